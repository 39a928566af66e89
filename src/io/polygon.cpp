#include "io/polygon.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "core/float3.hpp"

namespace lichtraum {
namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

constexpr std::size_t max_ear_corners = 256;  // cutting ears takes the square of it

void add_fan(std::span<std::uint32_t const> corners, Triangles& triangles) {
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) triangles.push_back({corners[0], corners[i], corners[i + 1]});
}

/// The shorter way to a good cut: along the diagonal whose triangles look the same way.
void add_quad(std::span<Float3 const> corners, Triangles& triangles) {
  Vec3 const a = to_vec3(corners[0]), b = to_vec3(corners[1]), c = to_vec3(corners[2]), d = to_vec3(corners[3]);
  bool const cut_from_a = !(glm::dot(glm::cross(b - a, c - a), glm::cross(c - a, d - a)) < 0);
  if (cut_from_a) {
    triangles.insert(triangles.end(), {{0, 1, 2}, {0, 2, 3}});
  } else {
    triangles.insert(triangles.end(), {{1, 2, 3}, {1, 3, 0}});
  }
}

/// The polygon in the plane across its normal's largest axis, counter-clockwise. Newell's normal: it needs no plane
/// polygon and no convex corner to start from.
std::vector<glm::dvec2> projected(std::span<Float3 const> corners) {
  Vec3 normal(0);
  Vec3 const first = to_vec3(corners[0]);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    normal += glm::cross(to_vec3(corners[i]) - first, to_vec3(corners[i + 1]) - first);
  }
  int axis = 2;
  for (int a = 0; a < 2; ++a) {
    if (std::abs(normal[a]) > std::abs(normal[axis])) axis = a;
  }
  int const x = (axis + 1) % 3, y = (axis + 2) % 3;
  double const sign = normal[axis] < 0 ? -1 : 1;
  std::vector<glm::dvec2> points;
  for (Float3 const& corner : corners) {
    Vec3 const p = to_vec3(corner) - first;
    points.push_back({sign * p[x], p[y]});
  }
  return points;
}

/// Twice the signed area.
double area(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) { return (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y); }

void cut_ears(std::vector<glm::dvec2> const& points, Triangles& triangles) {
  std::vector<std::uint32_t> ring(points.size());
  for (std::size_t i = 0; i < ring.size(); ++i) ring[i] = std::uint32_t(i);
  std::size_t tests_left = 4 * points.size() * points.size();
  auto const is_ear = [&](std::size_t at) {
    std::size_t const n = ring.size();
    std::uint32_t const ia = ring[(at + n - 1) % n], ib = ring[at], ic = ring[(at + 1) % n];
    glm::dvec2 const a = points[ia], b = points[ib], c = points[ic];
    if (!(area(a, b, c) > 0)) return false;
    for (std::uint32_t const i : ring) {
      if (tests_left > 0) --tests_left;
      glm::dvec2 const p = points[i];
      if (i == ia || i == ib || i == ic || p == a || p == b || p == c) continue;
      if (area(a, b, p) >= 0 && area(b, c, p) >= 0 && area(c, a, p) >= 0) return false;
    }
    return true;
  };
  // What is no ear becomes one when a neighbour is cut off (Eberly, Triangulation by Ear Clipping, 2002): it is not
  // tested again before that, so that a polygon that does not touch itself takes 3 n tests of n corners.
  std::vector<bool> is_known(points.size(), false);
  std::size_t at = 0, failures = 0;
  while (ring.size() > 3 && tests_left > 0) {
    std::size_t const n = ring.size();
    std::uint32_t const before = ring[(at + n - 1) % n], corner = ring[at], after = ring[(at + 1) % n];
    if (!is_known[corner] && is_ear(at)) {
      triangles.push_back({before, corner, after});
      ring.erase(ring.begin() + std::ptrdiff_t(at));
      is_known[before] = is_known[after] = false;
      failures = 0;
    } else {
      is_known[corner] = true;
      ++at;
      ++failures;
    }
    if (at >= ring.size()) at = 0;
    if (failures < ring.size()) continue;
    if (failures >= 2 * ring.size()) break;
    is_known.assign(points.size(), false);  // it touches itself, perhaps
  }
  add_fan(ring, triangles);  // the last triangle, or what crosses itself
}

}  // namespace

void triangulate(std::span<Float3 const> corners, Triangles& triangles) {
  if (corners.size() < 3) return;
  if (corners.size() == 3) {
    triangles.push_back({0, 1, 2});
  } else if (corners.size() == 4) {
    add_quad(corners, triangles);
  } else if (corners.size() <= max_ear_corners) {
    cut_ears(projected(corners), triangles);
  } else {
    for (std::uint32_t i = 1; i + 1 < corners.size(); ++i) triangles.push_back({0, i, i + 1});
  }
}

}  // namespace lichtraum
