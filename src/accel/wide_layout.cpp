#include "accel/wide_layout.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <future>
#include <limits>

#include "accel/collapse_plan.hpp"
#include "accel/half_area.hpp"
#include "core/parallel_ranges.hpp"
#include "core/start_threads.hpp"

namespace lichtraum {
namespace {

using device::BvhChild;
using device::uint;

/// The children of a wide node that is being made, from left to right.
class Children {
 public:
  std::size_t size() const { return size_; }
  BvhChild const& operator[](std::size_t i) const { return *items_[i]; }
  void push_back(BvhChild const& child) { items_[size_++] = &child; }

 private:
  std::array<BvhChild const*, WIDE_CHILDREN> items_;
  std::size_t size_ = 0;
};

/// Which child is in each lane, so that a ray that looks for any hit, and takes them in this order, soon has one:
/// leaves, which answer at once, then what is large, as Embree's builder has it.
std::array<std::uint8_t, WIDE_CHILDREN> order_of_visits(Children const& children) {
  std::array<double, WIDE_CHILDREN> half_areas;  // of numbers as large as floats can be
  std::array<std::uint8_t, WIDE_CHILDREN> order{};
  for (std::size_t i = 0; i < children.size(); ++i) {
    BvhChild const& c = children[i];
    double const x = double(c.max[0]) - double(c.min[0]), y = double(c.max[1]) - double(c.min[1]),
                 z = double(c.max[2]) - double(c.min[2]);
    half_areas[i] = half_area(x, y, z);
    order[i] = std::uint8_t(i);
  }
  auto const is_before = [&](std::uint8_t a, std::uint8_t b) {
    bool const a_is_leaf = children[a].count > 0, b_is_leaf = children[b].count > 0;
    return a_is_leaf != b_is_leaf ? a_is_leaf : half_areas[a] > half_areas[b];
  };
  std::stable_sort(order.begin(), order.begin() + children.size(), is_before);
  return order;
}

/// Makes the wide nodes. Plans say how many are in each subtree: so each knows where it goes.
class Collapser {
 public:
  Collapser(Bvh const& bvh, std::span<std::size_t const> stack_sizes_of_instances)
      : bvh_(bvh), stack_sizes_of_instances_(stack_sizes_of_instances) {
    bool const is_tree = !is_absent(bvh.nodes[0].children[1]);
    if (is_tree) plans_ = plan_collapse(bvh);
    wide_.nodes.resize(is_tree ? plans_[0].wide_nodes : 1);
    BlockCounts const blocks = is_tree ? plans_[0].blocks : blocks_in(bvh, bvh.nodes[0].children[0]);
    wide_.triangle_blocks.resize(blocks.triangles);
    wide_.sphere_blocks.resize(blocks.spheres);
  }

  WideBvh run() {
    std::vector<Subtree> open{{}};
    std::vector<Subtree> parts;
    while (!open.empty()) {
      Subtree const top = open.back();
      open.pop_back();
      if (plans_.empty() || plans_[top.binary].wide_nodes > part_size) {
        make_node(top, open);
      } else {
        parts.push_back(top);
      }
    }
    std::atomic<std::size_t> next = 0;
    for_parallel_ranges(parts.size(), 1, [&](std::size_t, std::size_t) {
      for (std::size_t i = next++; i < parts.size(); i = next++) make_subtree(parts[i]);
    });
    wide_.stack_size = stack_size_;
    return std::move(wide_);
  }

 private:
  /// That is to be made.
  struct Subtree {
    uint binary = 0;             ///< its root in the binary tree
    uint first_node = 0;         ///< where its wide nodes go
    BlockCounts first_block;     ///< where its blocks go
    std::size_t stack_size = 0;  ///< that the path to its root needs
  };
  /// In wide nodes: smaller ones are not worth a thread's attention.
  static constexpr std::size_t part_size = 256;

  void make_subtree(Subtree const& subtree) {
    std::vector<Subtree> open{subtree};
    while (!open.empty()) {
      Subtree const top = open.back();
      open.pop_back();
      make_node(top, open);
    }
  }

  /// Makes the root of a subtree. Adds those of its children that are nodes to `open`, the first one last. Blocks and
  /// nodes are numbered from left to right, whatever the lanes.
  void make_node(Subtree const& subtree, std::vector<Subtree>& open) {
    Children const children = gather(subtree.binary);
    std::array<uint, WIDE_CHILDREN> words{};
    Subtree next{0, subtree.first_node + 1, subtree.first_block, subtree.stack_size + stack_entries(children.size())};
    note_stack_size(next.stack_size);
    for (std::size_t i = 0; i < children.size(); ++i) {
      if (children[i].count == 0) continue;
      words[i] = make_leaf(children[i], next.first_block);
      note_stack_size(next.stack_size + stack_size_below(bvh_.references[children[i].first]));
    }
    std::size_t const first_open = open.size();
    for (std::size_t i = 0; i < children.size(); ++i) {
      if (children[i].count > 0) continue;
      next.binary = children[i].first;
      open.push_back(next);
      words[i] = WIDE_KIND_NODE << WIDE_INDEX_BITS | next.first_node;
      next.first_node += plans_[next.binary].wide_nodes;
      next.first_block.add(plans_[next.binary].blocks);
    }
    std::reverse(open.begin() + std::ptrdiff_t(first_open), open.end());
    fill_lanes(children, words, wide_.nodes[subtree.first_node]);
  }

  /// What waits in a node while one of its children is visited: each other child, or their lanes and the node.
  static std::size_t stack_entries(std::size_t children) {
    return children < 2 ? 0 : std::max<std::size_t>(children - 1, 2);
  }

  /// A ray that enters an instance keeps what waits in the world.
  std::size_t stack_size_below(device::PrimitiveReference const& leaf) const {
    return leaf.kind == PRIMITIVE_INSTANCE && !stack_sizes_of_instances_.empty() ? stack_sizes_of_instances_[leaf.index]
                                                                                 : 0;
  }

  static void fill_lanes(Children const& children, std::array<uint, WIDE_CHILDREN> const& words,
                         device::WideNode& node) {
    auto const order = order_of_visits(children);
    for (std::size_t lane = 0; lane < WIDE_CHILDREN; ++lane) {
      bool const is_present = lane < children.size();
      std::size_t const child = order[lane];
      for (int axis = 0; axis < 3; ++axis) {
        node.bounds[2 * axis][lane] = is_present ? children[child].min[axis] : DeviceBounds::infinity;
        node.bounds[2 * axis + 1][lane] = is_present ? children[child].max[axis] : -DeviceBounds::infinity;
      }
      node.children[lane] = is_present ? words[child] : 0;
    }
  }

  uint make_leaf(BvhChild const& leaf, BlockCounts& next) {
    auto const [kind, index] = bvh_.references[leaf.first];
    if (kind == PRIMITIVE_TRIANGLE) {
      wide_.triangle_blocks[next.triangles] = {leaf.first, leaf.count};
      return kind << WIDE_INDEX_BITS | next.triangles++;
    }
    if (kind == PRIMITIVE_SPHERE) {
      wide_.sphere_blocks[next.spheres] = {leaf.first, leaf.count};
      return kind << WIDE_INDEX_BITS | next.spheres++;
    }
    return kind << WIDE_INDEX_BITS | index;
  }

  void note_stack_size(std::size_t size) {
    std::size_t known = stack_size_;
    while (known < size && !stack_size_.compare_exchange_weak(known, size)) {
    }
  }

  /// The children of the wide node that begins at a binary node.
  Children gather(uint binary) const {
    Children children;
    device::BvhNode const& root = bvh_.nodes[binary];
    if (plans_.empty()) {
      if (!is_absent(root.children[0])) children.push_back(root.children[0]);
      return children;
    }
    struct Part {
      BvhChild const* child;
      std::size_t share;  ///< it may become so many children
    };
    std::array<Part, WIDE_CHILDREN> open;
    std::size_t size = 0;
    auto const share_out = [&](device::BvhNode const& node, std::size_t n, std::size_t for_left) {
      open[size++] = {&node.children[1], n - for_left};
      open[size++] = {&node.children[0], for_left};
    };
    share_out(root, WIDE_CHILDREN, plans_[binary].share_of_left(WIDE_CHILDREN));
    while (size > 0) {
      auto const [child, share] = open[--size];
      std::size_t const for_left = child->count > 0 ? 0 : plans_[child->first].share_of_left(share);
      if (for_left == 0) {
        children.push_back(*child);
      } else {
        share_out(bvh_.nodes[child->first], share, for_left);
      }
    }
    return children;
  }

  Bvh const& bvh_;
  std::span<std::size_t const> stack_sizes_of_instances_;
  BigVector<CollapsePlan> plans_;  // none of a tree without a second leaf
  WideBvh wide_;
  std::atomic<std::size_t> stack_size_ = 0;
};

}  // namespace

WideBvh collapse(Bvh const& bvh, std::span<std::size_t const> stack_sizes_of_instances) {
  return Collapser(bvh, stack_sizes_of_instances).run();
}

namespace {

void fill_triangle_block(WideBvh::Block const& block, std::span<device::PrimitiveReference const> references,
                         std::span<device::TrianglePrimitive const> triangles, device::TriangleBlock& filled,
                         device::PrimitiveTag* tags) {
  for (uint lane = 0; lane < BLOCK_LANES; ++lane) {
    bool const present = lane < block.count;
    device::TrianglePrimitive const* triangle = present ? &triangles[references[block.first + lane].index] : nullptr;
    for (int corner = 0; corner < 3; ++corner) {
      for (int axis = 0; axis < 3; ++axis) {
        filled.vertices[corner][axis][lane] =
            present ? triangle->vertices[corner][axis] : std::numeric_limits<float>::quiet_NaN();
      }
    }
    tags[lane] = present ? triangle->tag : device::PrimitiveTag{};
  }
}

}  // namespace

void fill_triangle_blocks(std::span<WideBvh::Block const> blocks,
                          std::span<device::PrimitiveReference const> references,
                          std::span<device::TrianglePrimitive const> triangles, std::span<device::TriangleBlock> filled,
                          std::span<device::PrimitiveTag> tags) {
  constexpr std::size_t part_size = 1 << 14;
  if (blocks.size() > part_size) {
    std::size_t const half = blocks.size() / 2;
    auto rest = std::async(thread_if_any, [&] {
      fill_triangle_blocks(blocks.subspan(half), references, triangles, filled.subspan(half),
                           tags.subspan(half * BLOCK_LANES));
    });
    fill_triangle_blocks(blocks.first(half), references, triangles, filled, tags);
    rest.get();
    return;
  }
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    fill_triangle_block(blocks[b], references, triangles, filled[b], &tags[b * BLOCK_LANES]);
  }
}

void fill_sphere_blocks(std::span<WideBvh::Block const> blocks, std::span<device::PrimitiveReference const> references,
                        std::span<device::SpherePrimitive const> spheres, std::span<device::SphereBlock> filled) {
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    for (uint lane = 0; lane < BLOCK_LANES; ++lane) {
      bool const present = lane < blocks[b].count;
      device::SpherePrimitive const sphere =
          present ? spheres[references[blocks[b].first + lane].index]
                  : device::SpherePrimitive{{}, std::numeric_limits<float>::quiet_NaN(), {}};
      for (int axis = 0; axis < 3; ++axis) filled[b].center[axis][lane] = sphere.center[axis];
      filled[b].radius[lane] = sphere.radius;
      filled[b].tags[lane] = sphere.tag;
    }
  }
}

}  // namespace lichtraum
