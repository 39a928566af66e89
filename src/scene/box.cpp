#include <glm/common.hpp>

#include "core/format_numbers.hpp"
#include "lichtraum/shapes.hpp"
#include "scene/check_finite.hpp"
#include "scene/passage.hpp"

namespace lichtraum {

Box::Box(std::string name, Vec3 const& p1, Vec3 const& p2, std::shared_ptr<Material const> material)
    : Shape(std::move(name), std::move(material)), min_(glm::min(p1, p2)), max_(glm::max(p1, p2)) {
  for (Vec3 const& corner : {p1, p2}) check_finite(corner, "a box's corner");
}

// The slab method (Kay and Kajiya 1986).
bool Box::closest_hit(Ray const& ray, double t_min, Hit& hit) const {
  Ray const local = object_from_world(ray);
  Passage passage;
  for (int axis = 0; axis < 3; ++axis) {
    passage.clip_to_slab(min_[axis], max_[axis], local.origin[axis], local.direction[axis], Mat3(1)[axis]);
  }
  return take_hit(*this, passage, t_min, hit);
}

bool Box::intersect(Ray const& ray, float& t) const { return intersect_closest(*this, ray, t); }

void Box::accept(ShapeVisitor& visitor) const { visitor.visit(*this); }

std::string Box::description() const {
  return fmt::format("min {}, max {}", format_numbers(min_), format_numbers(max_));
}

std::shared_ptr<Shape> Box::remake(std::shared_ptr<Material const> material) const {
  return std::make_shared<Box>(name(), min_, max_, std::move(material));
}

}  // namespace lichtraum
