#include "accel/collapse_plan.hpp"

#include <algorithm>
#include <array>
#include <future>
#include <limits>

#include "accel/half_area.hpp"
#include "core/start_threads.hpp"

namespace lichtraum {
namespace {

using device::BvhChild;
using device::uint;

/// What a subtree costs as at most n children of one wide node.
struct Costs {
  std::size_t leaves = 1;  ///< below; WIDE_CHILDREN - 1 stands for more, too
  /// By n, from 1 to `leaves`: the area of all wide nodes in it, and their number.
  std::array<float, WIDE_CHILDREN> area{};
  std::array<uint, WIDE_CHILDREN> wide_nodes{};
};

float half_area_of_both(BvhChild const& a, BvhChild const& b) {
  std::array<float, 3> size;
  for (std::size_t i = 0; i < 3; ++i) size[i] = std::max(a.max[i], b.max[i]) - std::min(a.min[i], b.min[i]);
  return half_area(size[0], size[1], size[2]);
}

/// The cheapest way to share n children among the two of a binary node.
struct Share {
  float area = std::numeric_limits<float>::infinity();
  std::size_t of_left = 1;
  std::size_t of_right = 1;

  Share(Costs const& left, Costs const& right, std::size_t n) {
    std::size_t const most = std::min(n - 1, left.leaves);  // more than its leaves are of no use
    std::size_t const least = std::min(n - std::min(n - 1, right.leaves), most);
    for (std::size_t k = least; k <= most; ++k) {
      std::size_t const others = std::min(n - k, right.leaves);
      float const sum = left.area[k] + right.area[others];
      if (sum < area) area = sum, of_left = k, of_right = others;
    }
  }
};

class Planner {
 public:
  explicit Planner(Bvh const& bvh) : bvh_(bvh), plans_(bvh.nodes.size()) {}

  /// Plans the subtree that is nodes [root, end): nodes lie in depth-first order.
  Costs plan(std::size_t root, std::size_t end) {
    auto const& [left, right] = bvh_.nodes[root].children;
    if (end - root <= part_size || left.count > 0 || right.count > 0) return plan_by_itself(root, end);
    auto later = std::async(thread_if_any, [&, &second = right] { return plan(second.first, end); });
    Costs const of_left = plan(left.first, right.first);
    Costs const of_right = later.get();
    return combine(root, of_left, of_right);
  }

  BigVector<CollapsePlan> take() { return std::move(plans_); }

 private:
  /// Smaller subtrees are not worth a thread.
  static constexpr std::size_t part_size = 1 << 12;

  Costs plan_by_itself(std::size_t root, std::size_t end) {
    static constexpr Costs leaf;
    // From the last node to the first, the subtrees below a node are what was planned last.
    std::array<Costs, BVH_MAX_DEPTH + 1> open;
    std::size_t size = 0;
    for (std::size_t i = end; i-- > root;) {
      auto const& [left, right] = bvh_.nodes[i].children;
      Costs const& of_left = left.count > 0 ? leaf : open[--size];
      Costs const& of_right = right.count > 0 ? leaf : open[--size];
      open[size++] = combine(i, of_left, of_right);
    }
    return open[0];
  }

  Costs combine(std::size_t binary, Costs const& left, Costs const& right) {
    auto const& children = bvh_.nodes[binary].children;
    CollapsePlan plan;
    for (BvhChild const& child : children) {
      plan.blocks.add(child.count > 0 ? blocks_in(bvh_, child) : plans_[child.first].blocks);
    }
    Share const as_node(left, right, WIDE_CHILDREN);
    plan.set_share_of_left(WIDE_CHILDREN, as_node.of_left);
    plan.wide_nodes = 1 + left.wide_nodes[as_node.of_left] + right.wide_nodes[as_node.of_right];
    Costs costs;
    costs.leaves = std::min<std::size_t>(left.leaves + right.leaves, WIDE_CHILDREN - 1);
    costs.area[1] = half_area_of_both(children[0], children[1]) + as_node.area;
    costs.wide_nodes[1] = plan.wide_nodes;
    for (std::size_t n = 2; n <= costs.leaves; ++n) {
      Share const share(left, right, n);
      bool const is_shared = share.area < costs.area[1];
      costs.area[n] = is_shared ? share.area : costs.area[1];
      costs.wide_nodes[n] =
          is_shared ? left.wide_nodes[share.of_left] + right.wide_nodes[share.of_right] : plan.wide_nodes;
      if (is_shared) plan.set_share_of_left(n, share.of_left);
    }
    for (std::size_t n = costs.leaves + 1; n < WIDE_CHILDREN; ++n) plan.set_share_of_left(n, left.leaves);
    plans_[binary] = plan;
    return costs;
  }

  Bvh const& bvh_;
  BigVector<CollapsePlan> plans_;
};

}  // namespace

BlockCounts blocks_in(Bvh const& bvh, BvhChild const& leaf) {
  if (leaf.count == 0) return {};
  uint const kind = bvh.references[leaf.first].kind;
  return {kind == PRIMITIVE_TRIANGLE ? 1u : 0u, kind == PRIMITIVE_SPHERE ? 1u : 0u};
}

BigVector<CollapsePlan> plan_collapse(Bvh const& bvh) {
  Planner planner(bvh);
  planner.plan(0, bvh.nodes.size());
  return planner.take();
}

}  // namespace lichtraum
