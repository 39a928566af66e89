#pragma once

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

inline SceneShading shading_of(Scene const& scene) {
  return {scene.ambient(), scene.background, scene.tone_map, scene.up};
}

}  // namespace lichtraum
