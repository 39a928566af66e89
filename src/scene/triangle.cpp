#include <cmath>

#include "lichtraum/shapes.hpp"
#include "scene/leaf_hit.hpp"

namespace lichtraum {

Triangle::Triangle(std::string name, Vec3 const& a, Vec3 const& b, Vec3 const& c,
                   std::shared_ptr<Material const> material)
    : Shape(std::move(name), std::move(material)), vertices_{a, b, c} {}

// Three edge functions: on which side of each edge the ray passes, as scalar triple products of its direction and the
// edge's end points seen from its origin. Swapping the end points only swaps the sign, to the last bit, so a ray that
// misses a triangle across an edge hits the neighbour that shares the edge (compare Woop, Benthin and Wald 2013).
bool Triangle::closest_hit(Ray const& ray, double t_min, Hit& hit) const {
  Vec3 const ab = vertices_[1] - vertices_[0];
  Vec3 const ac = vertices_[2] - vertices_[0];
  Vec3 const normal = glm::cross(ab, ac);
  // Below this the cross product of two edges is nothing but rounding: the three points are on one line.
  constexpr double no_area = 1e-14;
  if (!(glm::length(normal) > no_area * glm::length(ab) * glm::length(ac))) return false;

  Ray const local = object_from_world(ray);
  Vec3 const a = vertices_[0] - local.origin;
  Vec3 const b = vertices_[1] - local.origin;
  Vec3 const c = vertices_[2] - local.origin;
  double const u = glm::dot(local.direction, glm::cross(b, c));
  double const v = glm::dot(local.direction, glm::cross(c, a));
  double const w = glm::dot(local.direction, glm::cross(a, b));
  bool const all_left = u >= 0 && v >= 0 && w >= 0;
  bool const all_right = u <= 0 && v <= 0 && w <= 0;
  if (!(all_left || all_right)) return false;

  double const t = glm::dot(normal, a) / glm::dot(normal, local.direction);
  if (!(t > t_min && t < hit.t)) return false;
  hit = leaf_hit(*this, t, normal);
  return true;
}

bool Triangle::intersect(Ray const& ray, float& t) const { return intersect_closest(*this, ray, t); }

void Triangle::accept(ShapeVisitor& visitor) const { visitor.visit(*this); }

}  // namespace lichtraum
