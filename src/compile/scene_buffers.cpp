#include "compile/scene_buffers.hpp"

#include <utility>

#include "compile/emissive_shapes.hpp"
#include "compile/light_choice.hpp"
#include "compile/light_table.hpp"
#include "compile/material_table.hpp"
#include "compile/object_compiler.hpp"

namespace lichtraum {

SceneBuffers compile_scene(FlatScene&& scene, Registry<Light> const& lights, TreeLayout layout,
                           SceneBuffers const* previous, std::optional<EnvironmentLight> const& environment,
                           Vec3 const& up) {
  ObjectCompiler compiler(layout, previous);
  auto world = compiler.take(std::move(scene.objects[0]));
  std::vector<CompiledObject> objects(1);  // the world's comes last: it needs the others' bounds
  for (std::size_t i = 1; i < scene.objects.size(); ++i) {
    objects.push_back(compiler.build(compiler.take(std::move(scene.objects[i]))));
  }
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    compiler.add_instance(i, scene.instances[i], objects[scene.instances[i].object], *world);
  }
  CompiledObject const built = compiler.build(std::move(world));
  SceneBuffers& buffers = compiler.buffers();
  buffers.root_node = built.root_node;
  buffers.world_bounds = built.bounds;
  buffers.crowding = built.crowding;
  buffers.stack_size = built.stack_size;
  compiler.note_features();
  compiler.finish();
  buffers.triangle_count = buffers.triangles.size();
  buffers.sphere_count = buffers.spheres.size();
  if (layout != TreeLayout::binary) {  // they are in the blocks
    buffers.triangles = {};
    buffers.spheres = {};
  }
  MaterialTable table = make_material_table(scene.materials);
  buffers.textures = std::move(table.textures);
  buffers.texels = std::move(table.texels);
  ShadingTables& shading = buffers.shading;
  shading.materials = std::move(table.phong);
  shading.pbr_materials = std::move(table.pbr);
  shading.lights = make_light_table({lights.begin(), lights.end()}, buffers.world_bounds);
  shading.features |= table.features | features_of(shading.lights);
  shading.up = up;
  set_environment(shading, environment, previous ? &previous->shading : nullptr);
  find_emissive_shapes(buffers, objects, built, scene.instances);
  set_light_choices(shading, buffers);
  buffers.unrepresentable += scene.unrepresentable;
  return std::move(buffers);
}

device::SceneConstants scene_constants(SceneBuffers const& scene, ShadingTables const& shading) {
  device::SceneConstants constants{};
  constants.root_node = scene.root_node;
  constants.light_count = device::uint(shading.lights.size());
  constants.emissive_triangle_count = device::uint(scene.emissive_triangles.size());
  constants.emissive_solid_count = device::uint(scene.emissive_solids.size());
  constants.features = shading.features;
  constants.ray_epsilon = DEFAULT_RAY_EPSILON;
  constants.light_choice_count = device::uint(shading.light_choices.size());
  constants.distant_importance = shading.distant_importance;
  if (!shading.light_choices.empty()) {
    constants.environment_probability = shading.light_probabilities[shading.lights.size()];
  }
  if (shading.environment) set_environment(constants, *shading.environment_table, *shading.environment, shading.up);
  return constants;
}

}  // namespace lichtraum
