#pragma once

#include <stdexcept>

#include "lichtraum/scene.hpp"

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

/// Throws std::invalid_argument for an environment whose map is missing or not as large as it says.
inline SceneShading shading_of(Scene const& scene) {
  if (scene.environment) {
    EnvironmentMap const* const map = scene.environment->map.get();
    if (!map || map->width <= 0 || map->height <= 0 ||
        map->radiance.size() != 3 * std::size_t(map->width) * std::size_t(map->height)) {
      throw std::invalid_argument(
          "an environment light needs a map of at least one pixel, with three numbers for each");
    }
  }
  return {scene.ambient(), scene.background, scene.tone_map, scene.up};
}

}  // namespace lichtraum
