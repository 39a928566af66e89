#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "compile/environment_table.hpp"
#include "compile/scene_arrays.hpp"
#include "lichtraum/scene_edits.hpp"

namespace lichtraum {

struct SceneBuffers;

/// What surfaces and lights are like: all of a scene that can change without a look at its shapes.
struct ShadingTables : device::ShadingArrays {
  device::uint features = 0;      ///< SCENE_...
  float distant_importance = -1;  ///< see SceneConstants
  Vec3 up{0, 1, 0};               ///< of the scene
  std::optional<EnvironmentLight> environment;
  std::shared_ptr<EnvironmentTable const> environment_table =  ///< of its map; without elements where there is none
      std::make_shared<EnvironmentTable>();
};

/// Calls f(array) for each array of the shading that kernels take; they come after those of a SceneBuffers.
template <class F>
void for_each_array(ShadingTables const& tables, F const& f) {
  device::for_each_array(static_cast<device::ShadingArrays const&>(tables), f);
  device::for_each_array(static_cast<device::EnvironmentArrays const&>(*tables.environment_table), f);
}

/// Makes it the environment of the tables. `known`: others, whose table of the same map serves again; null: none.
void set_environment(ShadingTables& tables, std::optional<EnvironmentLight> const& environment,
                     ShadingTables const* known);

/// Which features lights ask kernels for: SCENE_...
device::uint features_of(BigVector<device::PunctualLight> const& lights);

/// The tables of a compiled scene after edits. `materials`: whose entries its materials are, as FlatScene lists them.
ShadingTables edit_tables(SceneBuffers const& scene, std::vector<Material const*> const& materials,
                          SceneEdits const& edits);

}  // namespace lichtraum
