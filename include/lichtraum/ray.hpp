#pragma once

#include "lichtraum/api.hpp"
#include "lichtraum/math.hpp"

namespace LICHTRAUM_API lichtraum {

/// The half-line origin + t * direction, t > 0. With a unit direction, t is a distance.
struct Ray {
  Vec3 origin{0};
  Vec3 direction{0, 0, -1};

  Vec3 at(double t) const { return origin + t * direction; }
};

}  // namespace lichtraum
