#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <future>
#include <limits>
#include <span>
#include <thread>

#include "accel/bvh.hpp"

namespace lichtraum {
namespace {

constexpr std::size_t bin_count = 16;
constexpr std::size_t max_leaf_size = 4;
/// Visiting a node costs about as much as testing one primitive.
constexpr float node_cost = 1.0f;
/// Smaller subtrees are not worth a thread.
constexpr std::size_t min_parallel_size = 1 << 15;

using Nodes = std::vector<device::BvhNode>;

/// primitives[begin, end) and what encloses them.
struct Range {
  std::size_t begin = 0;
  std::size_t end = 0;
  Bounds bounds;
  Bounds centers;
  std::size_t size() const { return end - begin; }
};

struct Split {
  int axis = 0;
  std::size_t bin = 0;  ///< bins below it go left
  float cost = std::numeric_limits<float>::infinity();
};

/// The path below a node of n primitives has at most this many nodes when every split halves.
std::size_t halving_depth(std::size_t n) { return std::size_t(std::bit_width(n - 1)); }

device::BvhChild make_child(Bounds const& bounds, std::size_t first, std::size_t count) {
  return {{bounds.min[0], bounds.min[1], bounds.min[2]},
          device::uint(first),
          {bounds.max[0], bounds.max[1], bounds.max[2]},
          device::uint(count)};
}

class Builder {
 public:
  explicit Builder(std::span<BuildPrimitive> primitives)
      : primitives_(primitives), spawn_depth_(std::size_t(std::bit_width(std::thread::hardware_concurrency())) + 2) {}

  Range enclose(std::size_t begin, std::size_t end) const {
    Range range{begin, end, {}, {}};
    for (std::size_t i = begin; i < end; ++i) {
      Bounds const& bounds = primitives_[i].bounds;
      range.bounds.add(bounds);
      for (int axis = 0; axis < 3; ++axis) {
        range.centers.min[axis] = std::min(range.centers.min[axis], bounds.center(axis));
        range.centers.max[axis] = std::max(range.centers.max[axis], bounds.center(axis));
      }
    }
    return range;
  }

  /// The subtree of a range with at least two primitives, its root first. Node numbers count from the subtree's root.
  Nodes build(Range const& range, std::size_t depth) {
    Nodes nodes;
    append(range, depth, nodes);
    return nodes;
  }

 private:
  void append(Range const& range, std::size_t depth, Nodes& nodes) {
    std::size_t const middle = partition(range, depth);
    std::size_t const self = nodes.size();
    nodes.emplace_back();
    Range const left = enclose(range.begin, middle);
    Range const right = enclose(middle, range.end);
    if (depth <= spawn_depth_ && std::min(left.size(), right.size()) >= min_parallel_size) {
      auto right_nodes = std::async(std::launch::async, [&] { return build(right, depth + 1); });
      nodes[self].children[0] = append_child(left, depth, nodes);
      std::size_t const offset = nodes.size();
      for (device::BvhNode node : right_nodes.get()) {
        for (device::BvhChild& child : node.children) {
          if (child.count == 0) child.first += device::uint(offset);
        }
        nodes.push_back(node);
      }
      nodes[self].children[1] = make_child(right.bounds, offset, 0);
    } else {
      device::BvhChild const left_child = append_child(left, depth, nodes);  // may move the nodes
      nodes[self].children[0] = left_child;
      device::BvhChild const right_child = append_child(right, depth, nodes);
      nodes[self].children[1] = right_child;
    }
  }

  device::BvhChild append_child(Range const& range, std::size_t depth, Nodes& nodes) {
    if (is_leaf(range)) return make_child(range.bounds, range.begin, range.size());
    std::size_t const first = nodes.size();
    append(range, depth + 1, nodes);
    return make_child(range.bounds, first, 0);
  }

  bool is_leaf(Range const& range) const {
    if (range.size() == 1) return true;
    if (range.size() > max_leaf_size || !is_only_triangles(range)) return false;
    // The best split's cost is relative to this range's area.
    return !(node_cost * range.bounds.half_area() + best_split(range).cost <
             float(range.size()) * range.bounds.half_area());
  }

  bool is_only_triangles(Range const& range) const {
    return std::all_of(primitives_.begin() + std::ptrdiff_t(range.begin),
                       primitives_.begin() + std::ptrdiff_t(range.end),
                       [](BuildPrimitive const& primitive) { return primitive.reference.kind == PRIMITIVE_TRIANGLE; });
  }

  /// Divides the range in two parts that are not empty; returns where the second begins.
  std::size_t partition(Range const& range, std::size_t depth) {
    // A child of a binned split may hold all but one primitive. Halving from here on must still keep to the limit.
    if (depth + halving_depth(range.size()) < BVH_MAX_DEPTH) {
      Split const split = best_split(range);
      if (std::isfinite(split.cost)) {
        auto const begin = primitives_.begin();
        auto const middle = std::partition(begin + std::ptrdiff_t(range.begin), begin + std::ptrdiff_t(range.end),
                                           [&](BuildPrimitive const& primitive) {
                                             return bin_of(primitive.bounds, range.centers, split.axis) < split.bin;
                                           });
        return std::size_t(middle - begin);
      }
    }
    return halve(range);
  }

  std::size_t halve(Range const& range) {
    int axis = 0;
    for (int other = 1; other < 3; ++other) {
      if (extent(range.centers, other) > extent(range.centers, axis)) axis = other;
    }
    std::size_t const middle = range.begin + range.size() / 2;
    auto const at = [&](std::size_t i) { return primitives_.begin() + std::ptrdiff_t(i); };
    std::nth_element(at(range.begin), at(middle), at(range.end),
                     [axis](auto const& a, auto const& b) { return a.bounds.center(axis) < b.bounds.center(axis); });
    return middle;
  }

  static float extent(Bounds const& bounds, int axis) { return bounds.max[axis] - bounds.min[axis]; }

  static std::size_t bin_of(Bounds const& bounds, Bounds const& centers, int axis) {
    float const position = (bounds.center(axis) - centers.min[axis]) / extent(centers, axis);
    return std::min(std::size_t(position * float(bin_count)), bin_count - 1);
  }

  /// The cost of its split is the sum over both sides of area times count; infinite when no plane separates anything.
  Split best_split(Range const& range) const {
    Split best;
    for (int axis = 0; axis < 3; ++axis) {
      float const width = extent(range.centers, axis);
      if (!(width > 0) || !std::isfinite(width)) continue;
      struct Bin {
        Bounds bounds;
        std::size_t count = 0;
      };
      std::array<Bin, bin_count> bins;
      for (std::size_t i = range.begin; i < range.end; ++i) {
        Bin& bin = bins[bin_of(primitives_[i].bounds, range.centers, axis)];
        bin.bounds.add(primitives_[i].bounds);
        ++bin.count;
      }
      std::array<float, bin_count> cost_from_right;  // of bins [i, end) on one side
      Bin sum;
      for (std::size_t i = bin_count; i-- > 1;) {
        sum.bounds.add(bins[i].bounds);
        sum.count += bins[i].count;
        cost_from_right[i] = sum.bounds.half_area() * float(sum.count);
      }
      sum = {};
      for (std::size_t i = 1; i < bin_count; ++i) {
        sum.bounds.add(bins[i - 1].bounds);
        sum.count += bins[i - 1].count;
        if (sum.count == 0 || sum.count == range.size()) continue;
        float const cost = sum.bounds.half_area() * float(sum.count) + cost_from_right[i];
        if (cost < best.cost) best = {axis, i, cost};
      }
    }
    return best;
  }

  std::span<BuildPrimitive> primitives_;
  std::size_t spawn_depth_;
};

}  // namespace

Bvh build_bvh(std::vector<BuildPrimitive>&& primitives) {
  Bvh bvh;
  Builder builder(primitives);
  Range const all = builder.enclose(0, primitives.size());
  bvh.bounds = all.bounds;
  if (primitives.size() >= 2) {
    bvh.nodes = builder.build(all, 1);
  } else {
    device::BvhChild const absent = make_child(Bounds(), 0, 0);
    bvh.nodes.push_back({{primitives.empty() ? absent : make_child(all.bounds, 0, 1), absent}});
  }
  bvh.references.reserve(primitives.size());
  for (BuildPrimitive const& primitive : primitives) bvh.references.push_back(primitive.reference);
  return bvh;
}

}  // namespace lichtraum
