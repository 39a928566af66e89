#pragma once

#include "scene/flat_scene.hpp"

namespace lichtraum {

/// The least y in the world of all that is drawn, infinite planes aside: of the shapes themselves, not of boxes around
/// them. Infinity where nothing is.
double lowest_point(FlatScene const& scene);

}  // namespace lichtraum
