#include <cmath>
#include <stdexcept>

#include "core/format_numbers.hpp"
#include "lichtraum/shapes.hpp"
#include "scene/cylinder_passage.hpp"

namespace lichtraum {

Cylinder::Cylinder(std::string name, Vec3 const& p1, Vec3 const& p2, double radius,
                   std::shared_ptr<Material const> material)
    : Shape(std::move(name), std::move(material)), p1_(p1), p2_(p2), radius_(radius) {
  if (!(radius > 0 && std::isfinite(radius))) throw std::invalid_argument("a cylinder's radius must be positive");
  if (!is_direction(p2 - p1)) throw std::invalid_argument("a cylinder's ends must be two points");
}

Bounds Cylinder::bounds() const {
  Bounds bounds;
  add_disc(bounds, p1_, p2_ - p1_, radius_);
  add_disc(bounds, p2_, p2_ - p1_, radius_);
  return bounds;
}

bool Cylinder::closest_hit(Ray const& ray, double t_min, Hit& hit) const {
  return take_hit(*this, cylinder_passage(object_from_world(ray), p1_, p2_, radius_), t_min, hit);
}

bool Cylinder::intersect(Ray const& ray, float& t) const { return intersect_closest(*this, ray, t); }

void Cylinder::accept(ShapeVisitor& visitor) const { visitor.visit(*this); }

std::string Cylinder::description() const {
  return fmt::format("{} to {}, radius {}", format_numbers(p1_), format_numbers(p2_), radius_);
}

std::shared_ptr<Shape> Cylinder::remake(std::shared_ptr<Material const> material) const {
  return std::make_shared<Cylinder>(name(), p1_, p2_, radius_, std::move(material));
}

}  // namespace lichtraum
