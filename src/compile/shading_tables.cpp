#include "compile/shading_tables.hpp"

#include <algorithm>

#include "compile/light_choice.hpp"
#include "compile/light_table.hpp"
#include "compile/material_table.hpp"
#include "compile/scene_buffers.hpp"

namespace lichtraum {

void set_environment(ShadingTables& tables, std::optional<EnvironmentLight> const& environment,
                     ShadingTables const* known) {
  tables.features &= ~SCENE_ENVIRONMENT;
  tables.environment = environment;
  if (!environment) {
    tables.environment_table = std::make_shared<EnvironmentTable>();
    return;
  }
  tables.features |= SCENE_ENVIRONMENT;
  tables.environment_table = known && known->environment_table->map == environment->map
                                 ? known->environment_table
                                 : std::make_shared<EnvironmentTable>(make_environment_table(environment->map));
}

device::uint features_of(BigVector<device::PunctualLight> const& lights) {
  auto const is_constant = [](device::PunctualLight const& light) { return light.kind == LIGHT_CONSTANT; };
  return std::all_of(lights.begin(), lights.end(), is_constant) ? 0 : SCENE_LIGHT_KINDS;
}

ShadingTables edit_tables(SceneBuffers const& scene, std::vector<Material const*> const& materials,
                          SceneEdits const& edits) {
  ShadingTables tables = scene.shading;
  for (std::size_t i = 0; i < materials.size(); ++i) {
    auto const edited = edits.materials.find(materials[i]);
    if (edited == edits.materials.end()) continue;
    tables.materials[i] = phong_material(edited->second);
    if (i < tables.pbr_materials.size() && edited->second.pbr()) {
      tables.pbr_materials[i] = pbr_material(*edited->second.pbr(), scene.shading.pbr_materials[i]);
    }
    tables.features |= features_of(edited->second);
  }
  if (edits.lights) {
    tables.lights = make_light_table(*edits.lights, scene.world_bounds);
    tables.features |= features_of(tables.lights);
  }
  set_environment(tables, edits.environment, &scene.shading);
  set_light_choices(tables, scene);
  return tables;
}

}  // namespace lichtraum
