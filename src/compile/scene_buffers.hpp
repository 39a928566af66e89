#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "compile/environment_table.hpp"
#include "compile/scene_arrays.hpp"
#include "core/content_hash.hpp"
#include "lichtraum/renderer.hpp"
#include "lichtraum/scene_edits.hpp"
#include "scene/device_bounds.hpp"
#include "scene/flat_scene.hpp"

namespace lichtraum {

struct PrimitiveRange {
  std::size_t first = 0;
  std::size_t count = 0;
};
/// By PRIMITIVE_...; that of instances is empty.
using PrimitiveRanges = std::array<PrimitiveRange, PRIMITIVE_PLANE + 1>;

/// One object's part of the arrays, so that a later scene in which it is the same can have it.
struct CompiledObject {
  ContentHash content;         ///< of its primitives, and where they begin in the arrays of their kinds
  device::uint root_node = 0;  ///< where its nodes begin, in `nodes` or `wide_nodes`
  device::uint node_count = 0;
  device::uint first_leaf = 0;  ///< where its `references` or `triangle_blocks` begin
  device::uint leaf_count = 0;
  device::uint first_sphere_block = 0;  ///< where its `sphere_blocks` begin
  device::uint sphere_block_count = 0;
  PrimitiveRanges ranges;             ///< where its primitives are, before the layout orders triangles and spheres
  DeviceBounds bounds;                ///< of what has an end
  bool is_unbounded = false;          ///< something has none
  std::size_t stack_size = 0;         ///< that a traversal of it and its instances needs; for the wide layout
  double crowding = 0;                ///< see accel/crowding.hpp
  std::uint64_t unrepresentable = 0;  ///< of its primitives, whose bounds do not fit a float
};

/// What surfaces and lights are like: all of a scene that can change without a look at its shapes.
struct ShadingTables : device::ShadingArrays {
  device::uint features = 0;      ///< SCENE_...
  float distant_importance = -1;  ///< see SceneConstants
  Vec3 up{0, 1, 0};               ///< of the scene
  std::optional<EnvironmentLight> environment;
  std::shared_ptr<EnvironmentTable const> environment_table =  ///< of its map; without elements where there is none
      std::make_shared<EnvironmentTable>();
};

/// A scene as the kernels read it: plain arrays, the hierarchies of all objects in one.
struct SceneBuffers : device::GeometryArrays {
  ShadingTables shading;
  TreeLayout layout = TreeLayout::binary;  ///< which arrays are filled
  std::size_t stack_size = 0;              ///< that a traversal needs; for the wide layout
  double crowding = 0;                     ///< of the world's hierarchy, with those below (accel/crowding.hpp)

  std::vector<std::uint32_t> flat_instances;  ///< where `instances` are in FlatScene::instances; stays on the host

  device::uint root_node = 0;  ///< of the world's hierarchy
  DeviceBounds world_bounds;   ///< of what has an end; empty when nothing is drawn that has
  std::vector<CompiledObject> objects;
  std::uint64_t unrepresentable = 0;  ///< primitives left out, see FlatScene
  std::uint64_t triangle_count = 0;
  std::uint64_t sphere_count = 0;
};

/// Calls f(array) for each array but the shading that kernels take, in the order of their parameters.
template <class F>
void for_each_array(SceneBuffers const& scene, F const& f) {
  device::for_each_array(scene, scene.layout == TreeLayout::binary, f);
}

/// Those of the shading, which come next.
template <class F>
void for_each_array(ShadingTables const& tables, F const& f) {
  device::for_each_array(static_cast<device::ShadingArrays const&>(tables), f);
  device::for_each_array(static_cast<device::EnvironmentArrays const&>(*tables.environment_table), f);
}

/// What kernels take after them.
device::SceneConstants scene_constants(SceneBuffers const& scene, ShadingTables const& shading);

/// Builds a hierarchy per object and puts everything into the device's arrays. Objects that are
/// the same in `previous` (a scene compiled for the same layout; null: none) get theirs from there, and so does the
/// same map.
SceneBuffers compile_scene(FlatScene&& scene, Registry<Light> const& lights, TreeLayout layout,
                           SceneBuffers const* previous = nullptr,
                           std::optional<EnvironmentLight> const& environment = {}, Vec3 const& up = {0, 1, 0});

/// The tables of a compiled scene after edits. `materials`: whose entries its materials are, as FlatScene lists them.
ShadingTables edit_tables(SceneBuffers const& scene, std::vector<Material const*> const& materials,
                          SceneEdits const& edits);

}  // namespace lichtraum
