#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <future>
#include <limits>
#include <span>
#include <thread>

#include "accel/bins.hpp"
#include "accel/bvh.hpp"

namespace lichtraum {
namespace {

constexpr std::size_t max_leaf_size = 4;
/// Visiting a node costs about as much as testing a leaf.
constexpr float node_cost = 1.0f;
/// Of testing a ray against n primitives: a whole leaf costs what a part of it does, as CPUs test four at once.
constexpr float test_cost(std::size_t n) { return float((n + max_leaf_size - 1) / max_leaf_size); }
/// Smaller subtrees are not worth a thread.
constexpr std::size_t min_parallel_size = 1 << 13;
/// Longer ranges are binned in parts of this size, on every core. The parts do not depend on the number of threads.
constexpr std::size_t part_size = 1 << 17;

using Nodes = std::vector<device::BvhNode>;

/// What lies in a range: bounds of the primitives, and of their centres.
struct Extents {
  LaneBounds bounds;
  LaneBounds centers;

  void add(LaneBounds const& primitive) {
    bounds.add(primitive);
    centers.add_point(primitive.center());
  }
  void add(Extents const& other) {
    bounds.add(other.bounds);
    centers.add(other.centers);
  }
};

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
      : primitives_(primitives), spawn_depth_(std::size_t(std::bit_width(std::thread::hardware_concurrency())) + 4) {}

  Range enclose(std::size_t begin, std::size_t end) const {
    auto const work = [this](std::size_t from, std::size_t to) {
      Extents extents;
      for (std::size_t i = from; i < to; ++i) extents.add(LaneBounds(primitives_[i]));
      return extents;
    };
    Extents const extents = in_parts<Extents>(begin, end, work);
    return {begin, end, extents.bounds.bounds(), extents.centers.bounds()};
  }

  /// The subtree of a range with at least two primitives, its root first. Node numbers count from the subtree's root.
  Nodes build(Range const& range, std::size_t depth) {
    Nodes nodes;
    nodes.reserve(range.size() / 2);
    append(range, best_split(range), depth, nodes);
    return nodes;
  }

 private:
  /// The sum of work(begin, end) over the parts of a range, on several threads where it is long.
  template <class Sum, class Work>
  static Sum in_parts(std::size_t begin, std::size_t end, Work const& work) {
    if (end - begin <= 2 * part_size) return work(begin, end);
    std::size_t const middle = begin + std::bit_floor(end - begin - 1);
    auto other = std::async(std::launch::async, [&] { return in_parts<Sum>(middle, end, work); });
    Sum sum = in_parts<Sum>(begin, middle, work);
    sum.add(other.get());
    return sum;
  }

  void append(Range const& range, Split const& split, std::size_t depth, Nodes& nodes) {
    std::size_t const middle = partition(range, split, depth);
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
    Bounds const& bounds = range.bounds;
    if (range.size() == 1) return make_child(bounds, range.begin, 1);
    Split const split = best_split(range);
    // The best split's cost is relative to this range's area.
    bool const is_leaf = range.size() <= max_leaf_size && is_only_triangles(range) &&
                         !(node_cost * bounds.half_area() + split.cost < test_cost(range.size()) * bounds.half_area());
    if (is_leaf) return make_child(bounds, range.begin, range.size());
    std::size_t const first = nodes.size();
    append(range, split, depth + 1, nodes);
    return make_child(bounds, first, 0);
  }

  bool is_only_triangles(Range const& range) const {
    auto const members = primitives_.subspan(range.begin, range.size());
    return std::all_of(members.begin(), members.end(),
                       [](BuildPrimitive const& primitive) { return primitive.reference.kind == PRIMITIVE_TRIANGLE; });
  }

  /// Divides the range in two parts that are not empty; returns where the second begins.
  std::size_t partition(Range const& range, Split const& split, std::size_t depth) {
    // A child of a binned split may hold all but one primitive. Halving from here on must still keep to the limit.
    if (depth + halving_depth(range.size()) >= BVH_MAX_DEPTH || !std::isfinite(split.cost)) return halve(range);
    Binning const binning(range.centers);
    auto const begin = primitives_.begin();
    auto const middle = std::partition(begin + std::ptrdiff_t(range.begin), begin + std::ptrdiff_t(range.end),
                                       [&](BuildPrimitive const& primitive) {
                                         return binning.bin_of(primitive.bounds, std::size_t(split.axis)) < split.bin;
                                       });
    return std::size_t(middle - begin);
  }

  std::size_t halve(Range const& range) {
    Bounds const& centers = range.centers;
    int axis = 0;
    for (int other = 1; other < 3; ++other) {
      if (centers.max[other] - centers.min[other] > centers.max[axis] - centers.min[axis]) axis = other;
    }
    std::size_t const middle = range.begin + range.size() / 2;
    auto const at = [&](std::size_t i) { return primitives_.begin() + std::ptrdiff_t(i); };
    std::nth_element(at(range.begin), at(middle), at(range.end),
                     [axis](auto const& a, auto const& b) { return a.bounds.center(axis) < b.bounds.center(axis); });
    return middle;
  }

  /// The cost of its split is the sum over both sides of area times test_cost; infinite when no plane separates
  /// anything.
  Split best_split(Range const& range) const {
    Binning const binning(range.centers);
    if (range.size() <= small_size) return best_split_of_few(range, binning);
    auto const work = [&](std::size_t begin, std::size_t end) {
      Bins bins;
      bins.add(primitives_.subspan(begin, end - begin), binning);
      return bins;
    };
    Bins const bins = in_parts<Bins>(range.begin, range.end, work);
    Split best;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (!binning.separates(axis)) continue;
      std::array<float, bin_count> cost_from_right;  // of bins [i, end) on one side
      LaneBounds bounds;
      std::size_t count = 0;
      for (std::size_t i = bin_count; i-- > 1;) {
        bounds.add(bins.bounds[axis][i]);
        count += bins.count[axis][i];
        cost_from_right[i] = count == 0 ? 0 : bounds.half_area() * test_cost(count);
      }
      bounds = {};
      count = 0;
      for (std::size_t i = 1; i < bin_count; ++i) {
        bounds.add(bins.bounds[axis][i - 1]);
        count += bins.count[axis][i - 1];
        if (count == 0 || count == range.size()) continue;
        float const cost = bounds.half_area() * test_cost(count) + cost_from_right[i];
        if (cost < best.cost) best = {int(axis), i, cost};
      }
    }
    return best;
  }

  /// For so few, most bins would be empty.
  static constexpr std::size_t small_size = 8;

  /// best_split without the bins that nothing falls into: the same splits, plane by plane between the members.
  Split best_split_of_few(Range const& range, Binning const& binning) const {
    Split best;
    auto const members = primitives_.subspan(range.begin, range.size());
    std::array<LaneBounds, small_size> bounds_of;
    std::array<Lanes, small_size> bins_of;
    for (std::size_t i = 0; i < members.size(); ++i) {
      bounds_of[i] = LaneBounds(members[i]);
      bins_of[i] = binning.bins_of(bounds_of[i]);
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (!binning.separates(axis)) continue;
      std::array<std::size_t, small_size> bin;
      std::array<std::size_t, small_size> order;
      for (std::size_t i = 0; i < members.size(); ++i) {
        bin[i] = Binning::rounded(bins_of[i][axis]);
        std::size_t place = i;
        for (; place > 0 && bin[order[place - 1]] > bin[i]; --place) order[place] = order[place - 1];
        order[place] = i;
      }
      std::array<float, small_size> cost_from_right;
      LaneBounds bounds;
      for (std::size_t i = members.size(); i-- > 1;) {
        bounds.add(bounds_of[order[i]]);
        cost_from_right[i] = bounds.half_area() * test_cost(members.size() - i);
      }
      bounds = {};
      for (std::size_t i = 1; i < members.size(); ++i) {
        bounds.add(bounds_of[order[i - 1]]);
        if (bin[order[i - 1]] == bin[order[i]]) continue;
        float const cost = bounds.half_area() * test_cost(i) + cost_from_right[i];
        if (cost < best.cost) best = {int(axis), bin[order[i]], cost};
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
    bvh.nodes.push_back({{primitives.empty() ? absent : make_child(bvh.bounds, 0, 1), absent}});
  }
  bvh.references.reserve(primitives.size());
  for (BuildPrimitive const& primitive : primitives) bvh.references.push_back(primitive.reference);
  return bvh;
}

}  // namespace lichtraum
