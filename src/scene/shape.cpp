#include "lichtraum/shape.hpp"

#include <fmt/format.h>

#include <ostream>

namespace lichtraum {
Transform const& Shape::world_from_object() const {
  static Transform const identity;
  return world_from_object_ ? *world_from_object_ : identity;
}

void Shape::apply(Transform const& t) { set_world_from_object(t * world_from_object()); }

void Shape::set_world_from_object(Transform const& t) {
  world_from_object_ = t.is_identity() ? nullptr : std::make_unique<Transform>(t);
}

Ray Shape::object_from_world(Ray const& ray) const {
  if (!world_from_object_) return ray;
  Mat4 const& inverse = world_from_object_->inverse_matrix();
  return {Vec3(inverse * glm::dvec4(ray.origin, 1)), Mat3(inverse) * ray.direction};
}

std::shared_ptr<Shape> Shape::copy(std::shared_ptr<Material const> material) const {
  auto copy = remake(std::move(material));
  if (world_from_object_) copy->set_world_from_object(*world_from_object_);
  return copy;
}

std::ostream& operator<<(std::ostream& out, Shape const& shape) {
  out << fmt::format("{} '{}': {}", name_of(shape.kind()), shape.name(), shape.description());
  if (shape.material()) out << fmt::format(", material '{}'", shape.material()->name());
  return out;
}

}  // namespace lichtraum
