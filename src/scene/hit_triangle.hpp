#pragma once

#include <array>

#include "lichtraum/ray.hpp"

namespace lichtraum {

struct TriangleHit {
  double t;
  Vec3 normal;       ///< by the winding, not normalised
  Vec3 barycentric;  ///< weights of the corners; they sum to 1
};

/// Whether `ray` hits the triangle with t_min < t < found.t; only then `found` is changed. Watertight: a ray that
/// misses a triangle across an edge hits the neighbour that shares the edge. A triangle without area is never hit.
///
/// Three edge functions tell on which side of each edge the ray passes: scalar triple products of its direction and the
/// edge's end points seen from its origin. Swapping the end points only swaps the sign, to the last bit (compare Woop,
/// Benthin and Wald 2013).
inline bool hit_triangle(Ray const& ray, std::array<Vec3, 3> const& vertices, double t_min, TriangleHit& found) {
  Vec3 const a = vertices[0] - ray.origin;
  Vec3 const b = vertices[1] - ray.origin;
  Vec3 const c = vertices[2] - ray.origin;
  double const u = glm::dot(ray.direction, glm::cross(b, c));
  double const v = glm::dot(ray.direction, glm::cross(c, a));
  double const w = glm::dot(ray.direction, glm::cross(a, b));
  bool const all_left = u >= 0 && v >= 0 && w >= 0;
  bool const all_right = u <= 0 && v <= 0 && w <= 0;
  if (!(all_left || all_right)) return false;

  Vec3 const ab = vertices[1] - vertices[0];
  Vec3 const ac = vertices[2] - vertices[0];
  Vec3 const normal = glm::cross(ab, ac);
  // Below this the cross product of two edges is nothing but rounding: the three points are on one line.
  constexpr double no_area = 1e-14;
  if (!(glm::length(normal) > no_area * glm::length(ab) * glm::length(ac))) return false;

  double const t = glm::dot(normal, a) / glm::dot(normal, ray.direction);
  if (!(t > t_min && t < found.t)) return false;
  found = {t, normal, Vec3(u, v, w) / (u + v + w)};
  return true;
}

}  // namespace lichtraum
