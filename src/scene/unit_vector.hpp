#pragma once

#include <algorithm>
#include <cmath>

#include "lichtraum/math.hpp"

namespace lichtraum {

/// `v` at unit length, also where the square of its length would underflow or overflow.
inline Vec3 unit_vector(Vec3 const& v) {
  double const largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  return glm::normalize(v / largest);
}

}  // namespace lichtraum
