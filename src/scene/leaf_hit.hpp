#pragma once

#include "lichtraum/shape.hpp"
#include "scene/unit_vector.hpp"

namespace lichtraum {

/// The hit of a leaf whose surface has `object_normal` in its own frame, seen from its parent's frame.
inline Hit leaf_hit(Shape const& shape, double t, Vec3 const& object_normal) {
  Hit hit;
  hit.t = t;
  hit.normal = unit_vector(shape.world_from_object().normal(object_normal));
  hit.shape = &shape;
  hit.linear_from_shape = Mat3(shape.world_from_object().matrix());
  return hit;
}

/// What every kind of shape answers to Shape::intersect.
inline bool intersect_closest(Shape const& shape, Ray const& ray, float& t) {
  Hit hit;
  if (!shape.closest_hit(ray, 0, hit)) return false;
  t = static_cast<float>(hit.t);
  return true;
}

}  // namespace lichtraum
