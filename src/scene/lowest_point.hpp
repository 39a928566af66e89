#pragma once

#include "scene/flat_scene.hpp"

namespace lichtraum {

/// How far along `up`, which has unit length, the lowest point of all that is drawn lies from the world's origin,
/// infinite planes aside: of the shapes themselves, not of boxes around them. Infinity where nothing is.
double lowest_point(FlatScene const& scene, Vec3 const& up);

}  // namespace lichtraum
