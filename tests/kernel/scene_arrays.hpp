#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "accel/bvh.hpp"
#include "accel/primitive_bounds.hpp"
#include "reference.hpp"
#include "shared/bvh.h"
#include "shared/geometry.h"
#include "shared/shading.h"
#include "support/opencl_probe.hpp"

namespace lichtraum::test {

/// What trace_closest returns; as in kernels/scene.clh.
struct ProbeHit {
  float t;
  device::uint kind, index, instance;
};
inline constexpr device::uint none = 0xffffffffu;

/// A scene for a probe, put together by hand: primitives are added to the open object, close_object makes its tree.
struct SceneArrays {
  std::vector<device::BvhNode> nodes;
  std::vector<device::PrimitiveReference> references;
  std::vector<device::TrianglePrimitive> triangles;
  std::vector<device::SpherePrimitive> spheres;
  std::vector<device::EllipsoidPrimitive> ellipsoids;
  std::vector<device::BoxPrimitive> boxes;
  std::vector<device::Instance> instances;
  std::vector<device::PhongMaterial> materials;
  std::vector<device::PunctualLight> lights;
  device::uint root_node = 0;  ///< of the object closed last: the world

  void add(device::TrianglePrimitive const& p) { add(triangles, p, PRIMITIVE_TRIANGLE); }
  void add(device::SpherePrimitive const& p) { add(spheres, p, PRIMITIVE_SPHERE); }
  void add(device::EllipsoidPrimitive const& p) { add(ellipsoids, p, PRIMITIVE_ELLIPSOID); }
  void add(device::BoxPrimitive const& p) { add(boxes, p, PRIMITIVE_BOX); }
  /// `bounds` are the object's, in its own frame.
  void add_instance(Affine const& world_from_object, device::uint object_root, DeviceBounds const& bounds) {
    Mat4 matrix(world_from_object.linear);
    matrix[3] = glm::dvec4(world_from_object.offset, 1);
    instances.push_back({to_device(world_from_object.inverse()), object_root, {}});
    open_.push_back(
        {map_bounds(Transform::from_matrix(matrix), bounds), {PRIMITIVE_INSTANCE, device::uint(instances.size() - 1)}});
  }
  /// The root node and the bounds of what was added since the last call.
  std::pair<device::uint, DeviceBounds> close_object() {
    Bvh bvh = build_bvh(open_);
    open_.clear();
    root_node = device::uint(nodes.size());
    for (auto& node : bvh.nodes) {
      for (auto& child : node.children) {
        child.first += device::uint(child.count > 0 ? references.size() : nodes_before_);
      }
      nodes.push_back(node);
    }
    references.insert(references.end(), bvh.references.begin(), bvh.references.end());
    nodes_before_ = nodes.size();
    return {root_node, bvh.bounds};
  }

  /// Followed by what the probe takes besides the scene.
  std::vector<ProbeArgument> arguments(std::vector<ProbeArgument> const& more) const {
    std::vector<ProbeArgument> all{value(root_node), in(nodes), in(references), in(triangles), in(spheres),
                                   in(ellipsoids),   in(boxes), in(instances),  in(materials), in(lights)};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }

 private:
  template <class Primitive>
  void add(std::vector<Primitive>& array, Primitive const& primitive, device::uint kind) {
    array.push_back(primitive);
    open_.push_back({bounds_of(primitive), {kind, device::uint(array.size() - 1)}});
  }

  std::vector<BuildPrimitive> open_;
  std::size_t nodes_before_ = 0;
};

}  // namespace lichtraum::test
