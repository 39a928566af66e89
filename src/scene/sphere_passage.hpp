#pragma once

#include "scene/passage.hpp"

namespace lichtraum {

/// Where the line of a ray runs inside a sphere. The discriminant comes from the line's point nearest to the centre.
inline Passage sphere_passage(Ray const& ray, Vec3 const& center, double radius) {
  Vec3 const from_center = ray.origin - center;
  double const a = glm::dot(ray.direction, ray.direction);
  double const b = -glm::dot(from_center, ray.direction);
  Vec3 const nearest = from_center + (b / a) * ray.direction;
  double const discriminant = (radius - glm::length(nearest)) * (radius + glm::length(nearest));
  Passage passage;
  if (!(discriminant >= 0)) {
    passage.make_empty();
    return passage;
  }
  double const distance = glm::length(from_center);
  auto const [near, far] = roots_of_quadratic(a, b, (distance - radius) * (distance + radius), a * discriminant);
  passage.clip(near, from_center + near * ray.direction, far, from_center + far * ray.direction);
  return passage;
}

}  // namespace lichtraum
