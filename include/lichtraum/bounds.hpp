#pragma once

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "lichtraum/api.hpp"
#include "lichtraum/transform.hpp"

namespace LICHTRAUM_API lichtraum {

/// An axis-parallel box, faces included. Empty until something is added. `Vector` is one of glm's of three coordinates.
template <class Vector>
struct BasicBounds {
  using Number = typename Vector::value_type;
  static constexpr Number infinity = std::numeric_limits<Number>::infinity();

  Vector min{infinity};
  Vector max{-infinity};

  bool is_empty() const { return !(min.x <= max.x && min.y <= max.y && min.z <= max.z); }
  /// Not that of an empty box, nor of one without end.
  bool is_finite() const {
    for (int axis = 0; axis < 3; ++axis) {
      if (!std::isfinite(min[axis]) || !std::isfinite(max[axis])) return false;
    }
    return true;
  }
  Vector center() const { return Number(0.5) * min + Number(0.5) * max; }

  /// A point of NaN changes nothing.
  void add(Vector const& point) {
    min = glm::min(min, point);
    max = glm::max(max, point);
  }
  void add(BasicBounds const& other) {
    min = glm::min(min, other.min);
    max = glm::max(max, other.max);
  }
};

/// In double precision: of the scene graph.
using Bounds = BasicBounds<Vec3>;

/// Corner `i` of 0..7: at `max` on x for bit 0, on y for bit 1, on z for bit 2.
inline Vec3 corner_of(Bounds const& bounds, int i) {
  return {i & 1 ? bounds.max.x : bounds.min.x, i & 2 ? bounds.max.y : bounds.min.y,
          i & 4 ? bounds.max.z : bounds.min.z};
}

/// Adds a flat disc at right angles to `axis`, which has any length but zero.
inline void add_disc(Bounds& bounds, Vec3 const& center, Vec3 const& axis, double radius) {
  Vec3 const n = glm::normalize(axis);
  Vec3 const extent = radius * Vec3(std::hypot(n.y, n.z), std::hypot(n.z, n.x), std::hypot(n.x, n.y));
  bounds.add(center - extent);
  bounds.add(center + extent);
}

/// The box around the mapped box; empty for an empty one.
inline Bounds mapped(Transform const& transform, Bounds const& bounds) {
  Bounds result;
  if (bounds.is_empty()) return result;
  for (int i = 0; i < 8; ++i) result.add(transform.point(corner_of(bounds, i)));
  return result;
}

}  // namespace lichtraum
