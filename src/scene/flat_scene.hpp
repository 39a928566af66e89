#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/content_hash.hpp"
#include "lichtraum/scene.hpp"
#include "scene/primitive_arrays.hpp"

namespace lichtraum {

/// Primitives in one common frame, in the structs that the device reads.
struct FlatObject : device::PrimitiveArrays {
  /// What shading interpolates. One entry a triangle; those that are missing at the end have nothing.
  BigVector<device::TriangleAttributes> triangle_attributes;
  /// Of spheres, and of ellipsoids, that have a colour of their own: 1 + where its four floats begin in the vertex
  /// data; 0, as for those that are missing at the end: there is none.
  BigVector<device::uint> sphere_colors;
  BigVector<device::uint> ellipsoid_colors;
  BigVector<device::uint> cylinder_colors;  ///< likewise; four floats for each of its ends
  BigVector<float> vertex_data;             ///< what they count in
  /// Its part of FlatScene::shapes.
  std::size_t first_shape = 0;
  std::size_t shape_count = 0;
  ContentHash content;  ///< of its primitives and what lies at their vertices; flatten fills it in

  std::size_t primitive_count() const {
    std::size_t count = 0;
    device::for_each_kind(*this, [&](auto const& primitives) { count += primitives.size(); });
    return count;
  }
};

/// One occurrence of objects[object] in the world. Instances do not nest.
struct FlatInstance {
  std::uint32_t object = 0;
  Transform world_from_object;
  std::size_t world_shapes_before = 0;  ///< how many of the world's own shapes the walk down from the roots met before
};

/// The scene graph without the graph: what is drawn, as two levels of plain lists.
struct FlatScene {
  /// objects[0] is the world: what occurs once, baked into world space, unless it is large and moves as one. The others
  /// are what instances show.
  std::vector<FlatObject> objects;
  std::vector<FlatInstance> instances;
  /// What PrimitiveTag::material and PrimitiveTag::shape count in. A shape is listed once for each time it was baked.
  /// The world's come first, then those of the other objects.
  std::vector<std::shared_ptr<Material const>> materials;
  std::vector<Shape const*> shapes;
  /// Primitives left out because their coordinates do not fit a float.
  std::uint64_t unrepresentable = 0;
};

}  // namespace lichtraum
