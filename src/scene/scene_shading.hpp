#pragma once

#include <stdexcept>

#include "lichtraum/scene.hpp"
#include "scene/check_finite.hpp"
#include "scene/unit_vector.hpp"

namespace lichtraum {

/// What shading needs of a scene besides its surfaces and point lights.
struct SceneShading {
  Rgb ambient{0};  ///< the sum of all lights' La
  Rgb background{0};
  ToneMap tone_map = ToneMap::none;  ///< what `automatic` means
  Vec3 up{0, 1, 0};                  ///< see Scene
};

inline Rgb ambient(std::vector<Light> const& lights) {
  Rgb sum(0);
  for (Light const& light : lights) sum += light.la();
  return sum;
}

/// Throws std::invalid_argument for an environment whose map is missing or not as large as it says, and for numbers of
/// it and an `up` that are not finite.
inline SceneShading shading_of(Scene const& scene) {
  if (scene.environment) {
    EnvironmentLight const& environment = *scene.environment;
    check_finite(environment.rotation_degrees, "the rotation of an environment");
    check_finite(environment.brightness, "the brightness of an environment");
    EnvironmentMap const* const map = environment.map.get();
    if (!map || map->width <= 0 || map->height <= 0 ||
        map->radiance.size() != 3 * std::size_t(map->width) * std::size_t(map->height)) {
      throw std::invalid_argument(
          "an environment light needs a map of at least one pixel, with three numbers for each");
    }
  }
  if (!is_direction(scene.up)) throw std::invalid_argument("a scene's up must be finite and not zero");
  return {scene.ambient(), scene.background, scene.tone_map, scene.up};
}

}  // namespace lichtraum
