#pragma once

/// What the kernels are compared with: plain double precision, by other formulae than the device code where there are
/// any.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <vector>

#include "lichtraum/math.hpp"
#include "shared/geometry.h"

namespace lichtraum::test {

using device::float4;

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr float float_infinity = std::numeric_limits<float>::infinity();
inline constexpr float float_nan = std::numeric_limits<float>::quiet_NaN();
inline constexpr double rounding_unit = 0x1p-24;

inline Vec3 to_vec3(float4 const& v) { return {v.x, v.y, v.z}; }
inline Vec3 to_vec3(float const* v) { return {v[0], v[1], v[2]}; }
inline float4 to_float4(Vec3 const& v, double w = 0) { return {float(v.x), float(v.y), float(v.z), float(w)}; }
inline double max_abs(Vec3 const& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// A ray as a probe reads it: floats.
struct ProbeRay {
  float4 origin;     // w unused
  float4 direction;  // w unused
  Vec3 at(double t) const { return to_vec3(origin) + t * to_vec3(direction); }
};

/// The same numbers in every run, whatever the standard library.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  double uniform(double low = 0, double high = 1) { return low + (high - low) * double(engine_() >> 11) * 0x1p-53; }
  std::size_t index(std::size_t count) { return std::size_t(uniform() * double(count)); }
  Vec3 in_cube(double half_side = 1) {
    double const x = uniform(-half_side, half_side), y = uniform(-half_side, half_side);
    return {x, y, uniform(-half_side, half_side)};
  }
  Vec3 direction() {
    for (;;) {
      Vec3 const v = in_cube();
      double const length = glm::length(v);
      if (length > 0.1 && length < 1) return v / length;
    }
  }
  Mat3 rotation() {
    Vec3 const z = direction();
    Vec3 const x = glm::normalize(glm::cross(z, std::abs(z.x) < 0.5 ? Vec3(1, 0, 0) : Vec3(0, 1, 0)));
    return Mat3(x, glm::cross(z, x), z);
  }

 private:
  std::mt19937_64 engine_;
};

/// p -> linear * p + offset
struct Affine {
  Mat3 linear{1};
  Vec3 offset{0};
  Vec3 point(Vec3 const& p) const { return linear * p + offset; }
  Affine inverse() const { return {glm::inverse(linear), -(glm::inverse(linear) * offset)}; }
};

inline device::AffineTransform to_device(Affine const& a) {
  auto const row = [&](int i) {
    return float4{float(a.linear[0][i]), float(a.linear[1][i]), float(a.linear[2][i]), float(a.offset[i])};
  };
  return {row(0), row(1), row(2)};
}

inline Affine from_device(device::AffineTransform const& m) {
  Affine a;
  std::array<float4, 3> const rows{m.row_x, m.row_y, m.row_z};
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) a.linear[k][i] = to_vec3(rows[std::size_t(i)])[k];
    a.offset[i] = rows[std::size_t(i)].w;
  }
  return a;
}

/// Where a line meets a closed or flat surface, and how clear-cut that is: the margin is positive for a hit, negative
/// for a miss, and about 0 where roundings decide; relative to the shape's size as seen from the ray.
struct Crossing {
  double t_enter = infinity;
  double t_leave = infinity;
  double margin = 0;
  bool hit() const { return margin >= 0; }
};

inline Crossing cross_sphere(Vec3 const& center, double radius, Vec3 const& o, Vec3 const& d) {
  double const length = glm::length(d);
  double const middle = glm::dot(center - o, d) / (length * length);
  double const distance = glm::length(o + middle * d - center);
  Crossing result;
  result.margin = (radius - distance) / (radius + rounding_unit * 8 * glm::length(center - o));
  if (distance > radius) return result;
  double const half = std::sqrt((radius - distance) * (radius + distance)) / length;
  result.t_enter = middle - half;
  result.t_leave = middle + half;
  return result;
}

inline Crossing cross_box(Vec3 const& min, Vec3 const& max, Vec3 const& o, Vec3 const& d) {
  Crossing result;
  result.t_enter = -infinity;
  double inside_margin = infinity;
  for (int axis = 0; axis < 3; ++axis) {
    if (d[axis] == 0) {
      inside_margin = std::min({inside_margin, o[axis] - min[axis], max[axis] - o[axis]});
      continue;
    }
    double const a = (min[axis] - o[axis]) / d[axis], b = (max[axis] - o[axis]) / d[axis];
    result.t_enter = std::max(result.t_enter, std::min(a, b));
    result.t_leave = std::min(result.t_leave, std::max(a, b));
  }
  double const size = max_abs(max - min) + max_abs(o - min);
  result.margin = std::min(inside_margin, (result.t_leave - result.t_enter) * max_abs(d)) / size;
  return result;
}

/// Cramer's rule; the margin is the smallest barycentric weight.
inline Crossing cross_triangle(Vec3 const& a, Vec3 const& b, Vec3 const& c, Vec3 const& o, Vec3 const& d) {
  Mat3 const m(b - a, c - a, -d);
  double const determinant = glm::determinant(m);
  Crossing result;
  result.margin = -1;
  if (determinant == 0) return result;
  Vec3 const rhs = o - a;
  double const v = glm::determinant(Mat3(rhs, c - a, -d)) / determinant;
  double const w = glm::determinant(Mat3(b - a, rhs, -d)) / determinant;
  result.margin = std::min({1 - v - w, v, w});
  result.t_enter = result.t_leave = glm::determinant(Mat3(b - a, c - a, rhs)) / determinant;
  return result;
}

/// How much a matt surface shows of a light that its bumpy normal faces: Chiang, Li and Burley 2019.
inline double bump_share(Vec3 const& smooth, Vec3 const& bumpy, Vec3 const& light) {
  double const g = std::clamp(glm::dot(smooth, light) / (glm::dot(bumpy, light) * glm::dot(smooth, bumpy)), 0.0, 1.0);
  return -g * g * g + g * g + g;
}

inline double nearest_in_front(Crossing const& c, double t_max = infinity) {
  if (!c.hit()) return infinity;
  double const t = c.t_enter > 0 ? c.t_enter : c.t_leave;
  return t > 0 && t < t_max ? t : infinity;
}

}  // namespace lichtraum::test
