#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "compile/compiled_object.hpp"
#include "compile/scene_arrays.hpp"
#include "compile/shading_tables.hpp"
#include "lichtraum/renderer.hpp"
#include "scene/device_bounds.hpp"
#include "scene/flat_scene.hpp"

namespace lichtraum {

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

/// What kernels take after them.
device::SceneConstants scene_constants(SceneBuffers const& scene, ShadingTables const& shading);

/// Builds a hierarchy per object and puts everything into the device's arrays. Objects that are
/// the same in `previous` (a scene compiled for the same layout; null: none) get theirs from there, and so does the
/// same map.
SceneBuffers compile_scene(FlatScene&& scene, Registry<Light> const& lights, TreeLayout layout,
                           SceneBuffers const* previous = nullptr,
                           std::optional<EnvironmentLight> const& environment = {}, Vec3 const& up = {0, 1, 0});

}  // namespace lichtraum
