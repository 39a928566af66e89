#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "lichtraum/math.hpp"

namespace lichtraum {

/// An axis-parallel box in single precision, as the device sees it. Empty until something is added.
struct Bounds {
  static constexpr float infinity = std::numeric_limits<float>::infinity();
  float min[3] = {infinity, infinity, infinity};
  float max[3] = {-infinity, -infinity, -infinity};

  void add(Bounds const& other) {
    for (int axis = 0; axis < 3; ++axis) {
      min[axis] = std::min(min[axis], other.min[axis]);
      max[axis] = std::max(max[axis], other.max[axis]);
    }
  }

  /// Rounds outwards: the point lies inside whatever the conversion to float did.
  void add(Vec3 const& p) {
    for (int axis = 0; axis < 3; ++axis) {
      auto const rounded = float(p[axis]);
      min[axis] = std::min(min[axis], double(rounded) > p[axis] ? std::nextafter(rounded, -infinity) : rounded);
      max[axis] = std::max(max[axis], double(rounded) < p[axis] ? std::nextafter(rounded, infinity) : rounded);
    }
  }

  bool is_empty() const { return !(min[0] <= max[0] && min[1] <= max[1] && min[2] <= max[2]); }
  bool is_finite() const {
    for (int axis = 0; axis < 3; ++axis) {
      if (!std::isfinite(min[axis]) || !std::isfinite(max[axis])) return false;
    }
    return true;
  }
  float center(int axis) const { return 0.5f * min[axis] + 0.5f * max[axis]; }

  /// Half the surface: all that the surface area heuristic needs. 0 when empty.
  float half_area() const {
    if (is_empty()) return 0;
    float const x = max[0] - min[0], y = max[1] - min[1], z = max[2] - min[2];
    return x * y + y * z + z * x;
  }
};

}  // namespace lichtraum
