#include <stdexcept>

#include "core/format_numbers.hpp"
#include "lichtraum/shapes.hpp"
#include "scene/check_finite.hpp"
#include "scene/leaf_hit.hpp"

namespace lichtraum {

Plane::Plane(std::string name, Vec3 const& point, Vec3 const& normal, std::shared_ptr<Material const> material)
    : Shape(std::move(name), std::move(material)), point_(point), normal_(normal) {
  check_finite(point, "a plane's point");
  if (!is_direction(normal)) throw std::invalid_argument("a plane's normal must be finite and not zero");
}

bool Plane::closest_hit(Ray const& ray, double t_min, Hit& hit) const {
  Ray const local = object_from_world(ray);
  double const t = glm::dot(point_ - local.origin, normal_) / glm::dot(local.direction, normal_);
  if (!(t > t_min && t < hit.t)) return false;
  hit = leaf_hit(*this, t, normal_);
  return true;
}

bool Plane::intersect(Ray const& ray, float& t) const { return intersect_closest(*this, ray, t); }

void Plane::accept(ShapeVisitor& visitor) const { visitor.visit(*this); }

std::string Plane::description() const {
  return fmt::format("point {}, normal {}", format_numbers(point_), format_numbers(normal_));
}

std::shared_ptr<Shape> Plane::remake(std::shared_ptr<Material const> material) const {
  return std::make_shared<Plane>(name(), point_, normal_, std::move(material));
}

}  // namespace lichtraum
