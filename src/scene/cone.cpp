#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/format_numbers.hpp"
#include "lichtraum/shapes.hpp"
#include "scene/passage.hpp"

namespace lichtraum {

Cone::Cone(std::string name, Vec3 const& base, Vec3 const& tip, double radius, std::shared_ptr<Material const> material)
    : Shape(std::move(name), std::move(material)), base_(base), tip_(tip), radius_(radius) {
  if (!(radius > 0 && std::isfinite(radius))) throw std::invalid_argument("a cone's radius must be positive");
  if (!is_direction(tip - base)) throw std::invalid_argument("a cone's tip must not lie in its base");
}

Bounds Cone::bounds() const {
  Bounds bounds;
  add_disc(bounds, base_, tip_ - base_, radius_);
  bounds.add(tip_);
  return bounds;
}

// Where the distance from the axis equals `width`, the cone's radius at that height: the double cone of which this is
// the lower half. (half_b^2 - a c) is Lagrange's identity for squares of which one counts negative, so nothing cancels
// but where the line grazes the cone.
bool Cone::closest_hit(Ray const& ray, double t_min, Hit& hit) const {
  Vec3 const axis = unit_vector(tip_ - base_);
  double const height = glm::length(tip_ - base_);
  double const slope = radius_ / height;
  NearRay const near(object_from_world(ray), 0.5 * (base_ + tip_), height + radius_);
  AxisSplit const origin(near.ray.origin - base_, axis);
  AxisSplit const direction(near.ray.direction, axis);
  double const width = slope * (height - origin.along);
  double const widening = -slope * direction.along;

  double const speed = glm::length(direction.across);
  double const distance = glm::length(origin.across);
  double const a = (speed - std::abs(widening)) * (speed + std::abs(widening));
  double const half_b = width * widening - glm::dot(origin.across, direction.across);
  double const c = (distance - std::abs(width)) * (distance + std::abs(width));
  double const radial = glm::length(widening * origin.across - width * direction.across);
  double const moment = glm::length(glm::cross(origin.across, direction.across));
  double discriminant = (radial - moment) * (radial + moment);
  bool const is_steep = a < 0;  // within both halves, above one root and below the other
  if (is_steep) discriminant = std::max(discriminant, 0.);
  if (!(discriminant >= 0)) return false;

  auto const [t1, t2] = roots_of_quadratic(a, half_b, c, discriminant);
  double const enter = !is_steep ? t1 : widening > 0 ? t2 : -Passage::infinity;
  double const leave = !is_steep ? t2 : widening > 0 ? Passage::infinity : t1;
  auto const normal_at = [&](double t) {
    Vec3 const across = origin.across + t * direction.across;
    double const length = glm::length(across);
    Vec3 const outward = length > 0 ? across / length : Vec3(0);
    return outward + slope * axis;
  };
  Passage passage;
  passage.clip(enter, normal_at(enter), leave, normal_at(leave));
  passage.clip_to_slab(0, height, origin.along, direction.along, axis);
  return take_hit(*this, near.undo(passage), t_min, hit);
}

bool Cone::intersect(Ray const& ray, float& t) const { return intersect_closest(*this, ray, t); }

void Cone::accept(ShapeVisitor& visitor) const { visitor.visit(*this); }

std::string Cone::description() const {
  return fmt::format("base {}, tip {}, radius {}", format_numbers(base_), format_numbers(tip_), radius_);
}

std::shared_ptr<Shape> Cone::remake(std::shared_ptr<Material const> material) const {
  return std::make_shared<Cone>(name(), base_, tip_, radius_, std::move(material));
}

}  // namespace lichtraum
