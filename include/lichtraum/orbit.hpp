#pragma once

#include "lichtraum/api.hpp"
#include "lichtraum/transform.hpp"

namespace LICHTRAUM_API lichtraum {

/// From where something is looked at.
struct Orbit {
  double azimuth_degrees = 0;    ///< to the right of its front, counterclockwise as seen from above
  double elevation_degrees = 0;  ///< above the horizon, -90..90
};

/// From where a picture shows most of a thing.
inline constexpr Orbit three_quarter_view{35, 20};

/// A camera's rotation: it looks from there at the origin, with `up` (of any length but 0) upwards. Where up is +y, the
/// front is at +z; the least rotation leads from there to other ups, so where up is +z, the front is at -y.
/// Throws std::invalid_argument for an `up` of length 0, and for numbers that are not finite.
Transform orbit_rotation(Orbit const& orbit, Vec3 const& up = {0, 1, 0});

}  // namespace lichtraum
