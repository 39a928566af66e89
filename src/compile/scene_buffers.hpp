#pragma once

#include <cstdint>
#include <vector>

#include "core/big_vector.hpp"
#include "core/content_hash.hpp"
#include "lichtraum/renderer.hpp"
#include "lichtraum/scene_edits.hpp"
#include "scene/device_bounds.hpp"
#include "scene/flat_scene.hpp"
#include "scene/object_numbers.hpp"
#include "shared/bvh.h"
#include "shared/geometry.h"
#include "shared/pbr_material.h"
#include "shared/shading.h"
#include "shared/vertex.h"
#include "shared/wide.h"

namespace lichtraum {

/// One object's part of the arrays, so that a later scene in which it is the same can have it.
struct CompiledObject {
  ContentHash content;         ///< of its primitives, and where they begin in the arrays of their kinds
  device::uint root_node = 0;  ///< where its nodes begin, in `nodes` or `wide_nodes`
  device::uint node_count = 0;
  device::uint first_leaf = 0;  ///< where its `references` or `triangle_blocks` begin
  device::uint leaf_count = 0;
  device::uint first_sphere_block = 0;  ///< where its `sphere_blocks` begin
  device::uint sphere_block_count = 0;
  DeviceBounds bounds;
  std::size_t stack_size = 0;         ///< that a traversal of it needs; for the wide layout
  std::uint64_t unrepresentable = 0;  ///< of its primitives, whose bounds do not fit a float
};

/// What surfaces and lights are like: all of a scene that can change without a look at its shapes.
struct ShadingTables {
  std::vector<device::PhongMaterial> materials;
  std::vector<device::PbrMaterial> pbr_materials;  ///< as many as materials; empty unless the scene needs them
  std::vector<device::PunctualLight> lights;
  device::uint features = 0;  ///< SCENE_...
};

/// A scene as the kernels read it: plain arrays, the hierarchies of all objects in one.
struct SceneBuffers : ShadingTables {
  Traversal traversal = Traversal::scalar;  ///< which arrays are filled
  /// Only for the scalar layout.
  BigVector<device::BvhNode> nodes;
  BigVector<device::PrimitiveReference> references;
  std::vector<device::TrianglePrimitive> triangles;
  std::vector<device::SpherePrimitive> spheres;
  /// Only for the others.
  BigVector<device::WideNode> wide_nodes;
  BigVector<device::TriangleBlock> triangle_blocks;
  BigVector<device::PrimitiveTag> triangle_tags;  ///< BLOCK_LANES a block
  BigVector<device::SphereBlock> sphere_blocks;
  std::size_t stack_size = 0;  ///< that a traversal needs
  /// For all.
  std::vector<device::EllipsoidPrimitive> ellipsoids;
  std::vector<device::BoxPrimitive> boxes;
  std::vector<device::Instance> instances;
  /// Empty unless the scene needs them.
  std::vector<device::Texture> textures;
  std::vector<device::uint> texels;
  std::vector<device::TriangleAttributes> triangle_attributes;  ///< one a triangle, as the layout counts them
  std::vector<float> vertex_data;

  ObjectNumbers object_numbers;  ///< stays on the host

  device::uint root_node = 0;  ///< of the world's hierarchy
  DeviceBounds world_bounds;   ///< empty when nothing is drawn
  std::vector<CompiledObject> objects;
  ContentHash content;                ///< of all that decides what rays see, whatever the layout
  std::uint64_t unrepresentable = 0;  ///< primitives left out, see FlatScene
  std::uint64_t triangle_count = 0;
  std::uint64_t sphere_count = 0;
};

/// Builds a hierarchy per object and puts everything into the device's arrays. `traversal` is not `automatic`. Objects
/// that are the same in `previous` (a scene compiled for the same traversal; null: none) get theirs from there.
SceneBuffers compile_scene(FlatScene&& scene, Registry<Light> const& lights, Traversal traversal,
                           SceneBuffers const* previous = nullptr);

/// The tables of a compiled scene after edits. `materials`: whose entries its materials are, as FlatScene lists them.
ShadingTables edit_tables(SceneBuffers const& scene, std::vector<Material const*> const& materials,
                          SceneEdits const& edits);

}  // namespace lichtraum
