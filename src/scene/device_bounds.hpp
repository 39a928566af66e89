#pragma once

#include <cmath>
#include <glm/vec3.hpp>

#include "lichtraum/bounds.hpp"

namespace lichtraum {

/// In single precision, as the device sees it.
using DeviceBounds = BasicBounds<glm::vec3>;

/// Rounds outwards: the point lies inside whatever the conversion to float did.
inline void add_point(DeviceBounds& bounds, Vec3 const& p) {
  for (int axis = 0; axis < 3; ++axis) {
    auto const rounded = float(p[axis]);
    float const below = double(rounded) > p[axis] ? std::nextafter(rounded, -DeviceBounds::infinity) : rounded;
    float const above = double(rounded) < p[axis] ? std::nextafter(rounded, DeviceBounds::infinity) : rounded;
    bounds.min[axis] = std::min(bounds.min[axis], below);
    bounds.max[axis] = std::max(bounds.max[axis], above);
  }
}

}  // namespace lichtraum
