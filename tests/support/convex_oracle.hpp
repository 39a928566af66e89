#pragma once

#include <cmath>

#include "lichtraum/ray.hpp"

namespace lichtraum::test {

/// Where a line is within a convex body: what analytic intersections are compared with, as it shares no formula with
/// them. A body is a convex function of points that is negative inside; each number here has 64 bits.
struct ConvexCrossing {
  long double least;  ///< of the function along the line: how deep the line is inside, if negative
  long double t_enter, t_leave;
};

struct LongVec3 {
  long double x, y, z;
};
inline LongVec3 point_at(Ray const& ray, long double t) {
  return {ray.origin.x + t * ray.direction.x, ray.origin.y + t * ray.direction.y, ray.origin.z + t * ray.direction.z};
}

/// Where a line is deepest in a body, and two places on either side of all of it.
struct DeepestPoint {
  long double least, t;
  long double before, after;
};

/// `body` lies within `reach` of `center`. By golden section.
template <class Body>
DeepestPoint deepest_point(Ray const& ray, Vec3 const& center, double reach, Body const& body) {
  auto const at = [&](long double t) { return body(point_at(ray, t)); };
  long double const speed = glm::length(ray.direction);
  long double const middle = glm::dot(center - ray.origin, ray.direction) / (speed * speed);
  long double low = middle - 2 * reach / speed, high = middle + 2 * reach / speed;
  long double const first = low, last = high;
  long double const ratio = (std::sqrt(5.0L) - 1) / 2;
  long double a = high - ratio * (high - low), b = low + ratio * (high - low);
  long double at_a = at(a), at_b = at(b);
  for (int i = 0; i < 120; ++i) {
    if (at_a < at_b) {
      high = b, b = a, at_b = at_a;
      a = high - ratio * (high - low), at_a = at(a);
    } else {
      low = a, a = b, at_a = at_b;
      b = low + ratio * (high - low), at_b = at(b);
    }
  }
  long double const t = (low + high) / 2;
  return {at(t), t, first, last};
}

/// The ends by bisection from the deepest point.
template <class Body>
ConvexCrossing cross_convex(Ray const& ray, Vec3 const& center, double reach, Body const& body) {
  DeepestPoint const deepest = deepest_point(ray, center, reach, body);
  auto const end = [&](long double outside) {
    long double within = deepest.t;
    for (int i = 0; i < 120; ++i) {
      long double const t = (within + outside) / 2;
      (body(point_at(ray, t)) <= 0 ? within : outside) = t;
    }
    return within;
  };
  return {deepest.least, end(deepest.before), end(deepest.after)};
}

inline auto sphere_body(Vec3 const& center, double radius) {
  return [=](LongVec3 const& p) { return std::hypot(p.x - center.x, p.y - center.y, p.z - center.z) - radius; };
}

/// Between two points around the line through both.
inline auto cylinder_body(Vec3 const& p1, Vec3 const& p2, double radius) {
  return [=](LongVec3 const& p) {
    LongVec3 const v{p.x - p1.x, p.y - p1.y, p.z - p1.z};
    Vec3 const way = p2 - p1;
    long double const height = std::sqrt((long double)(glm::dot(way, way)));
    long double const along = (v.x * way.x + v.y * way.y + v.z * way.z) / height;
    LongVec3 const across{v.x - along * way.x / height, v.y - along * way.y / height, v.z - along * way.z / height};
    long double const distance = std::hypot(across.x, across.y, across.z);
    return std::max({distance - radius, -along, along - height});
  };
}

/// Over a disc.
inline auto cone_body(Vec3 const& base, Vec3 const& tip, double radius) {
  return [=](LongVec3 const& p) {
    LongVec3 const v{p.x - base.x, p.y - base.y, p.z - base.z};
    Vec3 const way = tip - base;
    long double const height = std::sqrt((long double)(glm::dot(way, way)));
    long double const along = (v.x * way.x + v.y * way.y + v.z * way.z) / height;
    LongVec3 const across{v.x - along * way.x / height, v.y - along * way.y / height, v.z - along * way.z / height};
    long double const distance = std::hypot(across.x, across.y, across.z);
    long double const slant = std::hypot(height, (long double)(radius));
    return std::max((distance * height - (height - along) * radius) / slant, -along);
  };
}

}  // namespace lichtraum::test
