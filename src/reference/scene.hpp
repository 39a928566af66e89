#pragma once

#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "lichtraum/renderer.hpp"
#include "scene/scene_shading.hpp"

namespace lichtraum {

/// What the reference renderer keeps of a scene: a copy of its graph, and what shading needs.
struct ReferenceScene : SceneShading {
  std::vector<std::shared_ptr<Shape const>> roots;
  std::vector<Light> lights;  ///< all but ambient ones
  std::optional<EnvironmentLight> environment;
  double lowest_point = 0;  ///< see PreparedScene
};

/// All but ambient ones.
std::vector<Light> casting_shadows(std::vector<Light> const& lights);

/// All roots, or the shape called `root`, as they are: nothing is copied. Throws Error{usage} for an unknown root.
ReferenceScene make_reference_scene(Scene const& scene, std::string_view root);

}  // namespace lichtraum
