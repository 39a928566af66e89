#pragma once

#include <algorithm>
#include <cmath>

#include "core/float3.hpp"
#include "lichtraum/math.hpp"

namespace lichtraum {

/// Whether `v` has a direction, however long it is.
inline bool is_direction(Vec3 const& v) { return is_finite(v) && v != Vec3(0); }

/// `v` at unit length, also where the square of its length would underflow or overflow.
inline Vec3 unit_vector(Vec3 const& v) {
  double const largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  return glm::normalize(v / largest);
}

/// Of two directions; nearly so is enough, as no frame can be made of them.
inline bool are_parallel(Vec3 const& a, Vec3 const& b) {
  constexpr double smallest_sine = 1e-9;
  return glm::length(glm::cross(unit_vector(a), unit_vector(b))) < smallest_sine;
}

}  // namespace lichtraum
