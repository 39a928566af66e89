#pragma once

#include "scene/passage.hpp"

namespace lichtraum {

/// Where the line of a ray runs inside a cylinder with flat ends. Seen along its axis a cylinder is a circle: what is
/// `across` the axis meets that, what is `along` it meets the ends.
inline Passage cylinder_passage(Ray const& ray, Vec3 const& p1, Vec3 const& p2, double radius) {
  Vec3 const axis = unit_vector(p2 - p1);
  double const height = glm::length(p2 - p1);
  NearRay const near(ray, 0.5 * (p1 + p2), height + radius);
  AxisSplit const origin(near.ray.origin - p1, axis);
  AxisSplit const direction(near.ray.direction, axis);
  Passage passage;
  double const a = glm::dot(direction.across, direction.across);
  double const distance = glm::length(origin.across);
  double const moment = glm::length(glm::cross(origin.across, direction.across));
  double const discriminant = a * radius * radius - moment * moment;
  if (a > 0 ? !(discriminant >= 0) : !(distance <= radius)) {
    passage.make_empty();
    return passage;
  }
  if (a > 0) {
    double const half_b = -glm::dot(origin.across, direction.across);
    auto const [t1, t2] = roots_of_quadratic(a, half_b, (distance - radius) * (distance + radius), discriminant);
    passage.clip(t1, origin.across + t1 * direction.across, t2, origin.across + t2 * direction.across);
  }
  passage.clip_to_slab(0, height, origin.along, direction.along, axis);
  return near.undo(passage);
}

}  // namespace lichtraum
