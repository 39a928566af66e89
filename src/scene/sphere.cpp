#include <cmath>
#include <stdexcept>

#include "lichtraum/shapes.hpp"
#include "scene/leaf_hit.hpp"

namespace lichtraum {

Sphere::Sphere(std::string name, Vec3 const& center, double radius, std::shared_ptr<Material const> material)
    : Shape(std::move(name), std::move(material)), center_(center), radius_(radius) {
  if (!(radius > 0 && std::isfinite(radius))) throw std::invalid_argument("a sphere's radius must be positive");
}

// The quadratic without cancellation: Haines, Günther and Akenine-Möller, "Precision Improvements for Ray/Sphere
// Intersection", Ray Tracing Gems (2019), chapter 7. The discriminant comes from the ray's point nearest to the centre,
// and the smaller root from the product of both.
bool Sphere::closest_hit(Ray const& ray, double t_min, Hit& hit) const {
  Ray const local = object_from_world(ray);
  Vec3 const from_center = local.origin - center_;
  double const a = glm::dot(local.direction, local.direction);
  double const b = -glm::dot(from_center, local.direction);
  Vec3 const nearest = from_center + (b / a) * local.direction;
  double const discriminant = (radius_ - glm::length(nearest)) * (radius_ + glm::length(nearest));
  if (!(discriminant >= 0)) return false;

  double const distance = glm::length(from_center);
  double const c = (distance - radius_) * (distance + radius_);
  double const q = b + std::copysign(std::sqrt(a * discriminant), b);
  double near = c / q;
  double far = q / a;
  if (near > far) std::swap(near, far);

  double const t = near > t_min ? near : far;
  if (!(t > t_min && t < hit.t)) return false;
  hit = leaf_hit(*this, t, from_center + t * local.direction);
  return true;
}

bool Sphere::intersect(Ray const& ray, float& t) const { return intersect_closest(*this, ray, t); }

void Sphere::accept(ShapeVisitor& visitor) const { visitor.visit(*this); }

}  // namespace lichtraum
