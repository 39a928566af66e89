#include <cmath>
#include <stdexcept>

#include "core/format_numbers.hpp"
#include "lichtraum/shapes.hpp"
#include "scene/check_finite.hpp"
#include "scene/sphere_passage.hpp"

namespace lichtraum {

Sphere::Sphere(std::string name, Vec3 const& center, double radius, std::shared_ptr<Material const> material)
    : Shape(std::move(name), std::move(material)), center_(center), radius_(radius) {
  check_finite(center, "a sphere's centre");
  if (!(radius > 0 && std::isfinite(radius))) throw std::invalid_argument("a sphere's radius must be positive");
}

bool Sphere::closest_hit(Ray const& ray, double t_min, Hit& hit) const {
  return take_hit(*this, sphere_passage(object_from_world(ray), center_, radius_), t_min, hit);
}

bool Sphere::intersect(Ray const& ray, float& t) const { return intersect_closest(*this, ray, t); }

void Sphere::accept(ShapeVisitor& visitor) const { visitor.visit(*this); }

std::string Sphere::description() const {
  return fmt::format("center {}, radius {}", format_numbers(center_), radius_);
}

std::shared_ptr<Shape> Sphere::remake(std::shared_ptr<Material const> material) const {
  return std::make_shared<Sphere>(name(), center_, radius_, std::move(material));
}

}  // namespace lichtraum
