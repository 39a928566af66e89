#pragma once

#include <optional>
#include <unordered_map>
#include <vector>

#include "lichtraum/api.hpp"
#include "lichtraum/environment.hpp"
#include "lichtraum/light.hpp"
#include "lichtraum/material.hpp"

namespace LICHTRAUM_API lichtraum {

/// Other lights and materials for the shapes of a scene, as values beside it: the scene stays as it was read.
struct SceneEdits {
  std::optional<std::vector<Light>> lights{};  ///< instead of all of the scene's; nothing: those that it has
  /// Instead of some of those that its shapes have. Textures, and which of them, stay the material's own.
  std::unordered_map<Material const*, Material> materials;
  /// Instead of the scene's; nothing: none. With the scene's own map only numbers change; another one takes the time to
  /// compile it.
  std::optional<EnvironmentLight> environment{};
};

}  // namespace lichtraum
