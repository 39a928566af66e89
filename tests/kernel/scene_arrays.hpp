#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "accel/bvh.hpp"
#include "accel/primitive_bounds.hpp"
#include "compile/scene_arrays.hpp"
#include "reference.hpp"
#include "support/opencl_probe.hpp"

namespace lichtraum::test {

/// What trace_closest returns; as in kernels/scene.clh.
struct ProbeHit {
  float t;
  device::uint kind, index, instance;
};
inline constexpr device::uint none = 0xffffffffu;

/// A scene for a probe, put together by hand: primitives are added to the open object, close_object makes its tree.
struct SceneArrays : device::GeometryArrays, device::ShadingArrays, device::EnvironmentArrays {
  device::uint root_node = 0;          ///< of the object closed last: the world
  device::SceneConstants constants{};  ///< what the environment adds to them

  void add(device::TrianglePrimitive const& p) { add(triangles, p); }
  void add(device::SpherePrimitive const& p) { add(spheres, p); }
  void add(device::EllipsoidPrimitive const& p) { add(ellipsoids, p); }
  void add(device::BoxPrimitive const& p) { add(boxes, p); }
  void add(device::CylinderPrimitive const& p) { add(cylinders, p); }
  void add(device::ConePrimitive const& p) { add(cones, p); }
  void add(device::PlanePrimitive const& p) {
    planes.push_back(p);
    unbounded_.push_back({{}, {PRIMITIVE_PLANE, device::uint(planes.size() - 1)}});
  }
  /// `bounds` are the object's, in its own frame; empty if it is a plane.
  void add_instance(Affine const& world_from_object, device::uint object_root, DeviceBounds const& bounds) {
    Mat4 matrix(world_from_object.linear);
    matrix[3] = glm::dvec4(world_from_object.offset, 1);
    instances.push_back({to_device(world_from_object.inverse()), object_root, {}});
    (bounds.is_empty() ? unbounded_ : open_)
        .push_back({map_bounds(Transform::from_matrix(matrix), bounds),
                    {PRIMITIVE_INSTANCE, device::uint(instances.size() - 1)}});
  }
  /// The root node and the bounds of what was added since the last call.
  std::pair<device::uint, DeviceBounds> close_object() {
    Bvh bvh = build_bvh(open_, unbounded_);
    open_.clear();
    unbounded_.clear();
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
    std::vector<ProbeArgument> all;
    auto const add_array = [&](auto const& array) { all.push_back(in(array)); };
    device::for_each_array(*this, true, add_array);
    device::for_each_array(static_cast<device::ShadingArrays const&>(*this), add_array);
    device::for_each_array(static_cast<device::EnvironmentArrays const&>(*this), add_array);
    device::SceneConstants all_constants = constants;
    all_constants.root_node = root_node;
    all_constants.light_count = device::uint(lights.size());
    all_constants.features |= SCENE_TRANSPARENCY | SCENE_LIGHT_KINDS | SCENE_RARE_SHAPES;
    all_constants.ray_epsilon = DEFAULT_RAY_EPSILON;
    all.push_back(value(all_constants));
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }

 private:
  template <class Primitive>
  void add(BigVector<Primitive>& array, Primitive const& primitive) {
    array.push_back(primitive);
    open_.push_back({bounds_of(primitive), {device::primitive_kind<Primitive>, device::uint(array.size() - 1)}});
  }

  std::vector<BuildPrimitive> open_, unbounded_;
  std::size_t nodes_before_ = 0;
};

}  // namespace lichtraum::test
