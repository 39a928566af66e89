#pragma once

#include <optional>
#include <string>

#include "lichtraum/bounds.hpp"
#include "lichtraum/error.hpp"

namespace lichtraum {

/// What is to be taken off the coordinates of a model, in double precision, before they become floats: nothing, unless
/// the largest exceeds 1000 times the longest side of `box`, which is around them all. Then a place near its middle, of
/// no more digits than it needs.
std::optional<Vec3> far_origin(Bounds const& box);

/// Whether there may be such a place for a box that is this one once its coordinates are floats.
bool may_be_far(Bounds const& rounded);

/// Says that it was taken off.
Diagnostic moved_from(Vec3 const& origin, std::string const& file);

}  // namespace lichtraum
