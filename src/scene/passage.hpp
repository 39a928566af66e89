#pragma once

#include <cmath>
#include <limits>
#include <utility>

#include "scene/leaf_hit.hpp"

namespace lichtraum {

/// Where a line runs inside a convex solid: from t_enter to t_leave, with the outward normals there, of any length.
/// Begins as the whole line, and is clipped by one boundary after the other.
struct Passage {
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  double t_enter = -infinity;
  double t_leave = infinity;
  Vec3 enter_normal{0};
  Vec3 leave_normal{0};

  /// Also when something is NaN.
  bool is_empty() const { return !(t_enter <= t_leave); }
  void make_empty() {
    t_enter = infinity;
    t_leave = -infinity;
  }

  void clip(double enter, Vec3 const& normal_at_enter, double leave, Vec3 const& normal_at_leave) {
    if (!(enter <= leave)) make_empty();
    if (enter > t_enter) {
      t_enter = enter;
      enter_normal = normal_at_enter;
    }
    if (leave < t_leave) {
      t_leave = leave;
      leave_normal = normal_at_leave;
    }
  }

  /// Between the two planes that are `low` and `high` along `axis`; the line's coordinate along it is
  /// origin + t * direction.
  void clip_to_slab(double low, double high, double origin, double direction, Vec3 const& axis) {
    if (direction == 0) {  // parallel to both: between them or not
      if (!(origin >= low && origin <= high)) make_empty();
      return;
    }
    double const t_low = (low - origin) / direction;
    double const t_high = (high - origin) / direction;
    if (direction > 0) {
      clip(t_low, -axis, t_high, axis);
    } else {
      clip(t_high, axis, t_low, -axis);
    }
  }
};

/// The end of the passage that the ray of Shape::closest_hit meets.
inline bool take_hit(Shape const& shape, Passage const& passage, double t_min, Hit& hit) {
  if (passage.is_empty()) return false;
  bool const from_outside = passage.t_enter > t_min;
  double const t = from_outside ? passage.t_enter : passage.t_leave;
  if (!(t > t_min && t < hit.t)) return false;
  hit = leaf_hit(shape, t, from_outside ? passage.enter_normal : passage.leave_normal);
  return true;
}

/// The same line with its origin moved near a shape of that size around `center` where it is far away: there what is
/// left of large numbers would be rounding.
struct NearRay {
  Ray ray;
  double start = 0;  ///< t of the new origin

  NearRay(Ray const& r, Vec3 const& center, double size) : ray(r) {
    Vec3 const to_center = center - r.origin;
    if (!(glm::length(to_center) > 4 * size)) return;
    start = glm::dot(to_center, r.direction) / glm::dot(r.direction, r.direction);
    ray.origin = r.at(start);
  }
  /// A passage of this ray as one of the first.
  Passage undo(Passage passage) const {
    passage.t_enter += start;
    passage.t_leave += start;
    return passage;
  }
};

/// A vector's parts along a unit vector and at right angles to it.
struct AxisSplit {
  double along;
  Vec3 across;

  AxisSplit(Vec3 const& v, Vec3 const& axis) : along(glm::dot(v, axis)), across(v - along * axis) {}
};

/// The roots of a t^2 - 2 half_b t + c, the smaller first, without the difference of nearly equal numbers: Haines,
/// Günther and Akenine-Möller, "Precision Improvements for Ray/Sphere Intersection", Ray Tracing Gems (2019),
/// chapter 7. The caller knows how to compute the discriminant, half_b^2 - a c, without cancellation.
inline std::pair<double, double> roots_of_quadratic(double a, double half_b, double c, double discriminant) {
  double const q = half_b + std::copysign(std::sqrt(discriminant), half_b);
  double const large = q / a;
  double const small = q == 0 ? large : c / q;
  return small < large ? std::pair(small, large) : std::pair(large, small);
}

}  // namespace lichtraum
