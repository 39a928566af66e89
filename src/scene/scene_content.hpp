#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/content_hash.hpp"
#include "lichtraum/environment.hpp"
#include "lichtraum/scene_edits.hpp"
#include "scene/flat_scene.hpp"
#include "scene/scene_shading.hpp"

namespace lichtraum {

/// All that decides what rays see of a scene, as hashes, in the parts that change by themselves. Names do not count.
struct SceneContent {
  ContentHash shapes;                  ///< primitives, instances, textures: what edits leave as they are
  std::vector<ContentHash> materials;  ///< of FlatScene::materials, without their textures
  ContentHash lights;
  ContentHash environment_map;  ///< of none where there is no environment
  ContentHash environment;      ///< how its map is turned and how bright it is
  Vec3 up{0, 1, 0};             ///< of the scene
  friend bool operator==(SceneContent const&, SceneContent const&) = default;
};

/// Of an object's primitives and what lies at their vertices.
ContentHash content_of(FlatObject const& object);
/// Takes the objects' own hashes as flatten left them.
SceneContent content_of(FlatScene const& scene, std::vector<Light> const& lights,
                        std::optional<EnvironmentLight> const& environment, Vec3 const& up);
/// As if the scene had been written so. `materials` and `map`: whose hashes those are, as FlatScene lists them, and the
/// environment's (null: there is none).
SceneContent edit_content(SceneContent content, std::vector<Material const*> const& materials,
                          EnvironmentMap const* map, SceneEdits const& edits);

/// Of PreparedScene.
std::string scene_fingerprint(SceneContent const& content, SceneShading const& shading);

}  // namespace lichtraum
