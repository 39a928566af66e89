#pragma once

#include <vector>

#include "lichtraum/renderer.hpp"
#include "lichtraum/scene.hpp"

namespace lichtraum::test {

/// Small scenes that hold together what the path integrator can draw. Nearly no path is improbable in them: directions
/// without any plan find what shines, so that a few thousand samples tell 2 % of a block of pixels.
struct PathScene {
  char const* name;
  Scene scene;  ///< its first camera looks at it
  int max_depth = 4;
  bool has_alpha_plane = false;   ///< whether to draw it with one
  bool sees_environment = false;  ///< whether the environment is its background
  int cost = 1;                   ///< what a path costs, by that of the others
  Ground ground = Ground::none;
};
std::vector<PathScene> path_scenes();

}  // namespace lichtraum::test
