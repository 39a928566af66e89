#include <cmath>
#include <limits>

#include "lichtraum/shapes.hpp"
#include "scene/leaf_hit.hpp"

#include <glm/common.hpp>

namespace lichtraum {

Box::Box(std::string name, Vec3 const& p1, Vec3 const& p2, std::shared_ptr<Material const> material)
    : Shape(std::move(name), std::move(material)), min_(glm::min(p1, p2)), max_(glm::max(p1, p2)) {}

// The slab method (Kay and Kajiya 1986), which also remembers through which pair of planes the ray enters and leaves.
bool Box::closest_hit(Ray const& ray, double t_min, Hit& hit) const {
  Ray const local = object_from_world(ray);
  double t_enter = -std::numeric_limits<double>::infinity();
  double t_leave = std::numeric_limits<double>::infinity();
  int enter_axis = 0;
  int leave_axis = 0;
  for (int axis = 0; axis < 3; ++axis) {
    double const origin = local.origin[axis];
    double const direction = local.direction[axis];
    if (direction == 0) {  // parallel to these planes: between them or not
      if (!(origin >= min_[axis] && origin <= max_[axis])) return false;
      continue;
    }
    double t_first = (min_[axis] - origin) / direction;
    double t_second = (max_[axis] - origin) / direction;
    if (t_first > t_second) std::swap(t_first, t_second);
    if (!(t_first <= t_second)) return false;  // NaN
    if (t_first > t_enter) {
      t_enter = t_first;
      enter_axis = axis;
    }
    if (t_second < t_leave) {
      t_leave = t_second;
      leave_axis = axis;
    }
  }
  if (!(t_enter <= t_leave)) return false;

  bool const from_outside = t_enter > t_min;
  double const t = from_outside ? t_enter : t_leave;
  if (!(t > t_min && t < hit.t)) return false;
  int const axis = from_outside ? enter_axis : leave_axis;
  Vec3 normal(0);
  normal[axis] = std::copysign(1.0, local.direction[axis]) * (from_outside ? -1 : 1);
  hit = leaf_hit(*this, t, normal);
  return true;
}

bool Box::intersect(Ray const& ray, float& t) const { return intersect_closest(*this, ray, t); }

void Box::accept(ShapeVisitor& visitor) const { visitor.visit(*this); }

}  // namespace lichtraum
