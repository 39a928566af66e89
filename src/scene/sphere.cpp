#include <cmath>
#include <stdexcept>

#include "core/format_numbers.hpp"
#include "lichtraum/shapes.hpp"
#include "scene/passage.hpp"

namespace lichtraum {

Sphere::Sphere(std::string name, Vec3 const& center, double radius, std::shared_ptr<Material const> material)
    : Shape(std::move(name), std::move(material)), center_(center), radius_(radius) {
  if (!(radius > 0 && std::isfinite(radius))) throw std::invalid_argument("a sphere's radius must be positive");
}

// The discriminant comes from the line's point nearest to the centre.
bool Sphere::closest_hit(Ray const& ray, double t_min, Hit& hit) const {
  Ray const local = object_from_world(ray);
  Vec3 const from_center = local.origin - center_;
  double const a = glm::dot(local.direction, local.direction);
  double const b = -glm::dot(from_center, local.direction);
  Vec3 const nearest = from_center + (b / a) * local.direction;
  double const discriminant = (radius_ - glm::length(nearest)) * (radius_ + glm::length(nearest));
  if (!(discriminant >= 0)) return false;

  double const distance = glm::length(from_center);
  auto const [near, far] = roots_of_quadratic(a, b, (distance - radius_) * (distance + radius_), a * discriminant);
  Passage passage;
  passage.clip(near, from_center + near * local.direction, far, from_center + far * local.direction);
  return take_hit(*this, passage, t_min, hit);
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
