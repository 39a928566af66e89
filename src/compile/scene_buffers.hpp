#pragma once

#include <cstdint>
#include <vector>

#include "scene/flat_scene.hpp"
#include "shared/bvh.h"
#include "shared/geometry.h"
#include "shared/shading.h"

namespace lichtraum {

/// A scene as the kernels read it: plain arrays, the hierarchies of all objects in one.
struct SceneBuffers {
  std::vector<device::BvhNode> nodes;
  std::vector<device::PrimitiveReference> references;
  std::vector<device::TrianglePrimitive> triangles;
  std::vector<device::SpherePrimitive> spheres;
  std::vector<device::EllipsoidPrimitive> ellipsoids;
  std::vector<device::BoxPrimitive> boxes;
  std::vector<device::Instance> instances;
  std::vector<device::PhongMaterial> materials;
  std::vector<device::PointLight> lights;

  device::uint root_node = 0;         ///< of the world's hierarchy
  Bounds world_bounds;                ///< empty when nothing is drawn
  std::vector<Shape const*> shapes;   ///< what PrimitiveTag::shape counts in
  std::uint64_t unrepresentable = 0;  ///< primitives left out, see FlatScene
};

/// Builds a hierarchy per object and puts everything into the device's arrays.
SceneBuffers compile_scene(FlatScene&& scene, Registry<Light> const& lights);

}  // namespace lichtraum
