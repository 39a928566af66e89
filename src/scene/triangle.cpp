#include "core/format_numbers.hpp"
#include "lichtraum/shapes.hpp"
#include "scene/check_finite.hpp"
#include "scene/hit_triangle.hpp"
#include "scene/leaf_hit.hpp"

namespace lichtraum {

Triangle::Triangle(std::string name, Vec3 const& a, Vec3 const& b, Vec3 const& c,
                   std::shared_ptr<Material const> material)
    : Shape(std::move(name), std::move(material)), vertices_{a, b, c} {
  for (Vec3 const& vertex : vertices_) check_finite(vertex, "a triangle's corner");
}

Bounds Triangle::bounds() const {
  Bounds bounds;
  for (Vec3 const& vertex : vertices_) bounds.add(vertex);
  return bounds;
}

bool Triangle::closest_hit(Ray const& ray, double t_min, Hit& hit) const {
  TriangleHit found{hit.t, Vec3(0), Vec3(0)};
  if (!hit_triangle(object_from_world(ray), vertices_, t_min, found)) return false;
  hit = leaf_hit(*this, found.t, found.normal);
  return true;
}

bool Triangle::intersect(Ray const& ray, float& t) const { return intersect_closest(*this, ray, t); }

void Triangle::accept(ShapeVisitor& visitor) const { visitor.visit(*this); }

std::string Triangle::description() const {
  auto const& [a, b, c] = vertices_;
  return fmt::format("{}, {}, {}", format_numbers(a), format_numbers(b), format_numbers(c));
}

std::shared_ptr<Shape> Triangle::remake(std::shared_ptr<Material const> material) const {
  return std::make_shared<Triangle>(name(), vertices_[0], vertices_[1], vertices_[2], std::move(material));
}

}  // namespace lichtraum
