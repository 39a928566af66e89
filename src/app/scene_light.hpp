#pragma once

#include "lichtraum/scene.hpp"

namespace lichtraum::app {

/// Whether anything in a scene gives light.
enum class SceneLight {
  some,
  unused,  ///< only an environment, which the integrator does not show
  dimmed,  ///< only an environment, whose brightness is 0
  none,
};

/// Looks for lamps, ambient light, an environment, and surfaces that shine, whether they reach anything or not.
SceneLight light_in(Scene const& scene, Integrator integrator);

}  // namespace lichtraum::app
