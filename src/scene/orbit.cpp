#include "lichtraum/orbit.hpp"

#include <glm/trigonometric.hpp>
#include <stdexcept>

#include "core/elementary.hpp"
#include "scene/unit_vector.hpp"

namespace lichtraum {
namespace {

/// The least rotation from +y to `up`; of the many to -y, that about the z axis.
Transform rotation_from_y(Vec3 const& up) {
  Vec3 const wanted = unit_vector(up);
  Vec3 const axis = glm::cross(Vec3(0, 1, 0), wanted);
  double const sine = glm::length(axis);
  if (sine == 0) return wanted.y > 0 ? Transform() : Transform::rotation(180, Vec3(0, 0, 1));
  return Transform::rotation(glm::degrees(atan2_of(sine, wanted.y)), axis);
}

}  // namespace

Transform orbit_rotation(Orbit const& orbit, Vec3 const& up) {
  if (!is_direction(up)) throw std::invalid_argument("the up vector must be finite and not zero");
  return rotation_from_y(up) * Transform::rotation(orbit.azimuth_degrees, Vec3(0, 1, 0)) *
         Transform::rotation(-orbit.elevation_degrees, Vec3(1, 0, 0));
}

}  // namespace lichtraum
