#pragma once

#include <glm/geometric.hpp>

#include "lichtraum/shapes.hpp"

namespace lichtraum::test {

/// What a ray meets first of a shape; its `shape` is null where that is nothing.
inline Hit hit_of(Shape const& shape, Ray const& ray) {
  Hit hit;
  shape.closest_hit(ray, 0, hit);
  return hit;
}
inline Hit hit_of(Shape const& shape, Vec3 const& origin, Vec3 const& direction) {
  return hit_of(shape, {origin, direction});
}

/// Whether that is the hit's normal, but for roundings.
inline bool is_normal(Hit const& hit, Vec3 const& expected) { return glm::length(hit.normal - expected) < 1e-12; }

}  // namespace lichtraum::test
