#include "accel/crowding.hpp"

#include <algorithm>
#include <array>

#include "accel/half_area.hpp"

namespace lichtraum {
namespace {

using device::BvhChild;

/// As a double: that of what has no end is no float.
double half_area_of(BvhChild const& box) {
  double const x = double(box.max[0]) - box.min[0];
  double const y = double(box.max[1]) - box.min[1];
  double const z = double(box.max[2]) - box.min[2];
  return half_area(x, y, z);
}

BvhChild box_of_both(BvhChild const& a, BvhChild const& b) {
  BvhChild both = a;
  for (int axis = 0; axis < 3; ++axis) {
    both.min[axis] = std::min(a.min[axis], b.min[axis]);
    both.max[axis] = std::max(a.max[axis], b.max[axis]);
  }
  return both;
}

double tests_in(Bvh const& bvh, BvhChild const& leaf, std::span<double const> of_instances) {
  if (of_instances.empty()) return 1;  // and the references, which take time to fetch, do not matter
  device::PrimitiveReference const& first = bvh.references[leaf.first];
  return first.kind == PRIMITIVE_INSTANCE ? std::max(1.0, of_instances[first.index]) : 1.0;
}

}  // namespace

double crowding(Bvh const& bvh, std::span<double const> of_instances) {
  // From the last node to the first, the subtrees below a node are what was summed last.
  std::array<double, BVH_MAX_DEPTH + 1> open;  // half the area of their leaves, by test
  std::size_t size = 0;
  double most = 0;
  for (std::size_t i = bvh.nodes.size(); i-- > 0;) {
    auto const& children = bvh.nodes[i].children;
    double below = 0;
    for (BvhChild const& child : children) {
      if (is_absent(child)) continue;
      below += child.count == 0 ? open[--size] : tests_in(bvh, child, of_instances) * half_area_of(child);
    }
    open[size++] = below;
    // An absent child has min > max, and so adds nothing.
    double const area = half_area_of(box_of_both(children[0], children[1]));
    if (below > most * area) most = below / area;
  }
  return most;
}

}  // namespace lichtraum
