#include <cmath>
#include <stdexcept>

#include "core/format_numbers.hpp"
#include "lichtraum/shapes.hpp"
#include "scene/passage.hpp"

namespace lichtraum {

Cylinder::Cylinder(std::string name, Vec3 const& p1, Vec3 const& p2, double radius,
                   std::shared_ptr<Material const> material)
    : Shape(std::move(name), std::move(material)), p1_(p1), p2_(p2), radius_(radius) {
  if (!(radius > 0 && std::isfinite(radius))) throw std::invalid_argument("a cylinder's radius must be positive");
  double const height = glm::length(p2 - p1);
  if (!(height > 0 && std::isfinite(height))) throw std::invalid_argument("a cylinder's ends must be two points");
}

Bounds Cylinder::bounds() const {
  Bounds bounds;
  add_disc(bounds, p1_, p2_ - p1_, radius_);
  add_disc(bounds, p2_, p2_ - p1_, radius_);
  return bounds;
}

// Seen along its axis a cylinder is a circle: what is `across` the axis meets that, what is `along` it meets the ends.
bool Cylinder::closest_hit(Ray const& ray, double t_min, Hit& hit) const {
  Vec3 const axis = unit_vector(p2_ - p1_);
  double const height = glm::length(p2_ - p1_);
  NearRay const near(object_from_world(ray), 0.5 * (p1_ + p2_), height + radius_);
  AxisSplit const origin(near.ray.origin - p1_, axis);
  AxisSplit const direction(near.ray.direction, axis);
  Passage passage;
  double const a = glm::dot(direction.across, direction.across);
  double const distance = glm::length(origin.across);
  double const moment = glm::length(glm::cross(origin.across, direction.across));
  double const discriminant = a * radius_ * radius_ - moment * moment;
  if (a > 0 ? !(discriminant >= 0) : !(distance <= radius_)) return false;
  if (a > 0) {
    double const half_b = -glm::dot(origin.across, direction.across);
    auto const [t1, t2] = roots_of_quadratic(a, half_b, (distance - radius_) * (distance + radius_), discriminant);
    passage.clip(t1, origin.across + t1 * direction.across, t2, origin.across + t2 * direction.across);
  }
  passage.clip_to_slab(0, height, origin.along, direction.along, axis);
  return take_hit(*this, near.undo(passage), t_min, hit);
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
