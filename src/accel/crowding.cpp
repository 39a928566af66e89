#include "accel/crowding.hpp"

#include <algorithm>
#include <array>
#include <glm/vec3.hpp>

namespace lichtraum {
namespace {

using device::BvhChild;

/// Of the leaves below a node.
struct Leaves {
  double tests = 0;
  double area = 0;  ///< half of it, by test

  void add(Leaves const& other) {
    tests += other.tests;
    area += other.area;
  }
};

double half_area(glm::dvec3 const& size) { return size.x * size.y + size.y * size.z + size.z * size.x; }

DeviceBounds bounds_of(BvhChild const& child) {
  return {{child.min[0], child.min[1], child.min[2]}, {child.max[0], child.max[1], child.max[2]}};
}

double half_area(DeviceBounds const& bounds) { return half_area(glm::dvec3(bounds.max) - glm::dvec3(bounds.min)); }

double tests_in(Bvh const& bvh, BvhChild const& leaf, std::span<double const> of_instances) {
  if (of_instances.empty()) return 1;  // and the references, which take time to fetch, do not matter
  device::PrimitiveReference const& first = bvh.references[leaf.first];
  return first.kind == PRIMITIVE_INSTANCE ? std::max(1.0, of_instances[first.index]) : 1.0;
}

}  // namespace

double crowding(Bvh const& bvh, std::span<double const> of_instances) {
  // From the last node to the first, the subtrees below a node are what was summed last.
  std::array<Leaves, BVH_MAX_DEPTH + 1> open;
  std::size_t size = 0;
  double most = 0;
  for (std::size_t i = bvh.nodes.size(); i-- > 0;) {
    auto const& children = bvh.nodes[i].children;
    Leaves below;
    DeviceBounds bounds;
    for (BvhChild const& child : children) {
      if (is_absent(child)) continue;
      bounds.add(bounds_of(child));
      if (child.count == 0) {
        below.add(open[--size]);
      } else {
        double const tests = tests_in(bvh, child, of_instances);
        below.add({tests, tests * half_area(bounds_of(child))});
      }
    }
    open[size++] = below;
    double const area = bounds.is_empty() ? 0 : half_area(bounds);
    most = std::max(most, area > 0 ? below.area / area : below.tests);
  }
  return most;
}

}  // namespace lichtraum
