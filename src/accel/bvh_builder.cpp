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
#include "accel/sampled_splits.hpp"
#include "core/parallel_ranges.hpp"
#include "core/start_threads.hpp"

namespace lichtraum {
namespace {

/// Smaller subtrees are not worth a thread.
constexpr std::size_t min_parallel_size = 1 << 13;
/// Longer ranges are binned in parts of this size, on every core. The parts do not depend on the number of threads.
constexpr std::size_t part_size = 1 << 17;

/// What lies in a range: bounds of the primitives, and of their centres.
struct Extents {
  LaneBounds bounds;
  LaneBounds centers;

  void add(BuildPrimitive const& primitive) {
    LaneBounds const lanes(primitive);
    bounds.add(lanes);
    centers.add_point(lanes.center());
  }
  void add(Extents const& other) {
    bounds.add(other.bounds);
    centers.add(other.centers);
  }
};

/// Primitives [begin, end) in the order of the tree's leaves, and what encloses them.
struct Range {
  std::size_t begin = 0;
  std::size_t end = 0;
  int buffer = 0;  ///< in which they are
  Extents extents;
  std::size_t size() const { return end - begin; }
};

struct Ranges {
  Range left, right;
};

/// The path below a node of n primitives has at most this many nodes when every split halves.
std::size_t halving_depth(std::size_t n) { return std::size_t(std::bit_width(n - 1)); }

device::BvhChild make_child(DeviceBounds const& bounds, std::size_t first, std::size_t count) {
  return {{bounds.min[0], bounds.min[1], bounds.min[2]},
          device::uint(first),
          {bounds.max[0], bounds.max[1], bounds.max[2]},
          device::uint(count)};
}

using Nodes = std::vector<device::BvhNode>;

/// A subtree, depth-first, in pieces that follow each other. Numbers of nodes count from the beginning of a piece.
struct Subtree {
  std::vector<Nodes> pieces;
  std::size_t size = 0;

  void append(Nodes&& piece) {
    size += piece.size();
    pieces.push_back(std::move(piece));
  }
  void append(Subtree&& other) {
    size += other.size;
    std::move(other.pieces.begin(), other.pieces.end(), std::back_inserter(pieces));
  }
};

class Builder {
 public:
  Builder(std::span<BuildPrimitive> primitives, std::span<BuildPrimitive> space,
          std::span<device::PrimitiveReference> references)
      : buffers_{primitives, space},
        references_(references),
        spawn_depth_(std::size_t(std::bit_width(std::thread::hardware_concurrency())) + 4) {}

  Range enclose(std::size_t begin, std::size_t end, int buffer) const {
    auto const work = [&](std::size_t from, std::size_t to) {
      Extents extents;
      for (std::size_t i = from; i < to; ++i) extents.add(buffers_[buffer][i]);
      return extents;
    };
    return {begin, end, buffer, in_parts<Extents>(begin, end, work)};
  }

  /// The tree of all primitives, which are in the first buffer. The root is at `depth`.
  Subtree build_all(Range const& all, std::size_t depth) {
    if (all.size() < SampledSplits::min_size) return build(all, depth);
    SampledSplits const splits(buffers_[0], all.extents.bounds);
    return build_side({splits, splits.sort_into_cells(buffers_[0], buffers_[1])}, 0, depth).tree;
  }

  /// The subtree of a range that is not a leaf.
  Subtree build(Range const& range, std::size_t depth) {
    if (range.size() < min_parallel_size) {
      Subtree tree;
      Nodes nodes;
      nodes.reserve(range.size() / 2);
      append(range, depth, nodes);
      tree.append(std::move(nodes));
      return tree;
    }
    auto const [left, right] = divide(range, depth);
    auto const build_child = [&](Range const& child) { return is_leaf(child) ? Subtree() : build(child, depth + 1); };
    bool const on_a_thread = depth <= spawn_depth_ && std::min(left.size(), right.size()) >= min_parallel_size;
    auto later = std::async(on_a_thread ? thread_if_any : std::launch::deferred,
                            [&, &second = right] { return build_child(second); });
    Subtree left_tree = build_child(left);
    return put_above(left, std::move(left_tree), right, later.get());
  }

  /// The edge to a child, which is a leaf or whose root is at `first`.
  device::BvhChild child(Range const& range, std::size_t first) {
    DeviceBounds const bounds = range.extents.bounds.bounds();
    if (!is_leaf(range)) return make_child(bounds, first, 0);
    for (std::size_t i = range.begin; i < range.end; ++i) references_[i] = buffers_[range.buffer][i].reference;
    return make_child(bounds, range.begin, range.size());
  }

  bool is_leaf(Range const& range) const {
    if (range.size() == 1) return true;
    if (range.size() > max_leaf_size) return false;
    auto const members = primitives(range);
    device::uint const kind = members[0].reference.kind;
    return (kind == PRIMITIVE_TRIANGLE || kind == PRIMITIVE_SPHERE) &&
           std::all_of(members.begin(), members.end(), [&](auto const& p) { return p.reference.kind == kind; });
  }

 private:
  /// The subtree whose root has these children.
  Subtree put_above(Range const& left, Subtree&& left_tree, Range const& right, Subtree&& right_tree) {
    Subtree tree;
    tree.append({{{child(left, 1), child(right, 1 + left_tree.size)}}});
    tree.append(std::move(left_tree));
    tree.append(std::move(right_tree));
    return tree;
  }

  /// All primitives, sorted by cells, in the second buffer.
  struct Cells {
    SampledSplits const& splits;
    std::vector<std::size_t> first;  ///< where each cell begins, by its number, and the end
  };
  struct BuiltRange {
    Range range;
    Subtree tree;
  };

  /// What is in a cell, or on both sides of a split.
  BuiltRange build_side(Cells const& cells, std::uint32_t number, std::size_t depth) {
    if (cells.splits.is_cell(number)) {
      Range const range = enclose(cells.first[number], cells.first[number + 1], 1);
      return {range, is_leaf(range) ? Subtree() : build(range, depth)};
    }
    auto const& children = cells.splits.children(number);
    auto later = std::async(depth <= spawn_depth_ ? thread_if_any : std::launch::deferred,
                            [&] { return build_side(cells, children[1], depth + 1); });
    BuiltRange left = build_side(cells, children[0], depth + 1);
    BuiltRange right = later.get();
    Range range{left.range.begin, right.range.end, 1, left.range.extents};
    range.extents.add(right.range.extents);
    return {range, put_above(left.range, std::move(left.tree), right.range, std::move(right.tree))};
  }

  /// The sum of work(begin, end) over the parts of a range, on several threads where it is long.
  template <class Sum, class Work>
  static Sum in_parts(std::size_t begin, std::size_t end, Work const& work) {
    if (end - begin <= 2 * part_size) return work(begin, end);
    std::size_t const middle = begin + std::bit_floor(end - begin - 1);
    auto other = std::async(thread_if_any, [&] { return in_parts<Sum>(middle, end, work); });
    Sum sum = in_parts<Sum>(begin, middle, work);
    sum.add(other.get());
    return sum;
  }

  void append(Range const& range, std::size_t depth, Nodes& nodes) {
    auto const [left, right] = divide(range, depth);
    std::size_t const self = nodes.size();
    nodes.emplace_back();
    nodes[self].children[0] = child(left, self + 1);
    if (!is_leaf(left)) append(left, depth + 1, nodes);
    nodes[self].children[1] = child(right, nodes.size());
    if (!is_leaf(right)) append(right, depth + 1, nodes);
  }

  /// Neither part is empty.
  Ranges divide(Range const& range, std::size_t depth) {
    // A child of a binned split may hold all but one primitive. Halving from here on must still keep to the limit.
    if (depth + halving_depth(range.size()) >= BVH_MAX_DEPTH) return halve(range);
    Binning const binning(range.extents.centers);
    auto const work = [&](std::size_t begin, std::size_t end) {
      Bins bins;
      bins.add(buffers_[range.buffer].subspan(begin, end - begin), binning);
      return bins;
    };
    Bins const bins = in_parts<Bins>(range.begin, range.end, work);
    Split const split = bins.best_split();
    if (!std::isfinite(split.cost)) return halve(range);
    Ranges parts = partition(range, binning, split);
    parts.left.extents.bounds = bins.enclose(split.axis, 0, split.bin);
    parts.right.extents.bounds = bins.enclose(split.axis, split.bin, bin_count);
    return parts;
  }

  /// Moves the range's primitives to the other buffer, from left to right and from right to left. Leaves the bounds
  /// open, but for those of centres.
  Ranges partition(Range const& range, Binning const& binning, Split const& split) {
    switch (split.axis) {
      case 0:
        return partition_along<0>(range, binning, split.bin);
      case 1:
        return partition_along<1>(range, binning, split.bin);
      default:
        return partition_along<2>(range, binning, split.bin);
    }
  }
  /// With an axis that the compiler knows, all lanes have its answer in one instruction.
  template <int axis>
  Ranges partition_along(Range const& range, Binning const& binning, int bin) {
    BuildPrimitive* const to = buffers_[1 - range.buffer].data();
    BuildPrimitive* left = to + range.begin;
    BuildPrimitive* right = to + range.end;
    LaneBounds left_centers, right_centers;
    for (BuildPrimitive const& primitive : primitives(range)) {
      // Which side comes next is as good as random, which a branch would wait for. So both ends are written, and that
      // which is wrong again with the next.
      *left = right[-1] = primitive;
      Lanes const center = LaneBounds(primitive).center();
      IntLanes const below = binning.are_below(center, bin);
      IntLanes const is_left = __builtin_shufflevector(below, below, axis, axis, axis, axis);
      left -= is_left[0];  // all bits are -1
      right -= 1 + is_left[0];
      left_centers.add_point(Lanes(IntLanes(center) | ~is_left));  // all bits: NaN
      right_centers.add_point(Lanes(IntLanes(center) | is_left));
    }
    auto const middle = std::size_t(left - to);
    int const buffer = 1 - range.buffer;
    return {{range.begin, middle, buffer, {{}, left_centers}}, {middle, range.end, buffer, {{}, right_centers}}};
  }

  Ranges halve(Range const& range) {
    LaneBounds const& centers = range.extents.centers;
    int axis = 0;
    for (int other = 1; other < 3; ++other) {
      if (centers.max[other] - centers.min[other] > centers.max[axis] - centers.min[axis]) axis = other;
    }
    auto const members = primitives(range);
    auto const half = std::ptrdiff_t(members.size() / 2);
    std::nth_element(members.begin(), members.begin() + half, members.end(), [axis](auto const& a, auto const& b) {
      return a.bounds.center()[axis] < b.bounds.center()[axis];
    });
    std::size_t const middle = range.begin + std::size_t(half);
    return {enclose(range.begin, middle, range.buffer), enclose(middle, range.end, range.buffer)};
  }

  std::span<BuildPrimitive> primitives(Range const& range) const {
    return buffers_[range.buffer].subspan(range.begin, range.size());
  }

  std::span<BuildPrimitive> buffers_[2];
  std::span<device::PrimitiveReference> references_;
  std::size_t spawn_depth_;
};

BigVector<device::BvhNode> join(Subtree&& tree) {
  BigVector<device::BvhNode> nodes(tree.size);
  std::vector<std::size_t> first{0};
  for (Nodes const& piece : tree.pieces) first.push_back(first.back() + piece.size());
  for_parallel_ranges(tree.pieces.size(), 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      std::transform(tree.pieces[i].begin(), tree.pieces[i].end(), nodes.data() + first[i], [&](device::BvhNode node) {
        for (device::BvhChild& child : node.children) {
          if (child.count == 0) child.first += device::uint(first[i]);
        }
        return node;
      });
      tree.pieces[i] = {};
    }
  });
  return nodes;
}

/// A subtree whose leaves every ray enters: references [begin, end), one a leaf, halved again and again. Returns the
/// edge to it.
device::BvhChild append_unbounded(std::size_t begin, std::size_t end, BigVector<device::BvhNode>& nodes) {
  constexpr float far = std::numeric_limits<float>::max();  // no hit lies farther
  DeviceBounds const everywhere{glm::vec3(-far), glm::vec3(far)};
  if (end - begin == 1) return make_child(everywhere, begin, 1);
  std::size_t const self = nodes.size();
  std::size_t const middle = begin + (end - begin) / 2;
  nodes.emplace_back();
  device::BvhChild const left = append_unbounded(begin, middle, nodes);
  device::BvhChild const right = append_unbounded(middle, end, nodes);
  nodes[self] = {{left, right}};
  return make_child(everywhere, self, 0);
}

/// Makes `unbounded` and what is in the tree the two children of a new root.
void put_beside(Bvh& bvh, std::span<BuildPrimitive const> unbounded) {
  device::BvhNode const& old_root = bvh.nodes[0];
  device::BvhChild const absent = make_child(DeviceBounds(), 0, 0);
  bool const is_tree = !is_absent(old_root.children[1]);
  device::BvhChild tree = is_tree ? make_child(bvh.bounds, 0, 0) : old_root.children[0];
  std::size_t const first = bvh.references.size();
  for (BuildPrimitive const& primitive : unbounded) {
    bvh.references.push_back(primitive.reference);
    bvh.bounds.add(primitive.bounds);
  }
  BigVector<device::BvhNode> nodes;
  if (is_absent(tree) && unbounded.size() > 1) {
    append_unbounded(first, bvh.references.size(), nodes);
  } else {
    nodes.emplace_back();
    device::BvhChild const beside = append_unbounded(first, bvh.references.size(), nodes);
    std::size_t const moved = nodes.size();
    if (is_tree) {
      tree.first = device::uint(moved);
      nodes.insert(nodes.end(), bvh.nodes.begin(), bvh.nodes.end());
      for (device::BvhNode& node : std::span(nodes).subspan(moved)) {
        for (device::BvhChild& child : node.children) {
          if (child.count == 0) child.first += device::uint(moved);
        }
      }
    }
    nodes[0] = {{beside, is_absent(tree) ? absent : tree}};
  }
  bvh.nodes = std::move(nodes);
}

}  // namespace

Bvh build_bvh(std::span<BuildPrimitive> primitives, std::span<BuildPrimitive const> unbounded) {
  Bvh bvh;
  bvh.references.resize(primitives.size());
  BigVector<BuildPrimitive> space(primitives.size());
  Builder builder(primitives, space, bvh.references);
  Range const all = builder.enclose(0, primitives.size(), 0);
  bvh.bounds = all.extents.bounds.bounds();
  bool const is_below = !unbounded.empty();  // what will stand beside it is a level of its own
  if (primitives.size() >= 2 && !(is_below && builder.is_leaf(all))) {
    bvh.nodes = join(builder.build_all(all, is_below ? 2 : 1));
  } else {
    device::BvhChild const absent = make_child(DeviceBounds(), 0, 0);
    bvh.nodes.push_back({{primitives.empty() ? absent : builder.child(all, 0), absent}});
  }
  if (is_below) put_beside(bvh, unbounded);
  return bvh;
}

}  // namespace lichtraum
