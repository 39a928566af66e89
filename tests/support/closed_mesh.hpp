#pragma once

#include <array>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <map>
#include <numeric>
#include <vector>

#include "lichtraum/math.hpp"

namespace lichtraum::test {

using Corners = std::array<Vec3, 3>;

/// How often the surface winds around `p`. Of a closed one that is a whole number, and where it is not 0, every ray
/// from there meets the surface, whether that intersects itself or not.
inline double winding_number(std::vector<Corners> const& closed, Vec3 const& p) {
  double angle = 0;
  for (Corners const& corners : closed) {
    Vec3 const a = corners[0] - p, b = corners[1] - p, c = corners[2] - p;
    double const la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
    angle += std::atan2(glm::dot(a, glm::cross(b, c)),
                        la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb);
  }
  return angle / (2 * glm::pi<double>());
}

/// Those of the triangles that are parts of closed surfaces: connected at common corners, each edge as often one way as
/// the other. Corners are common if their numbers are the same.
inline std::vector<Corners> closed_parts(std::vector<Corners> const& triangles) {
  auto const less = [](Vec3 const& a, Vec3 const& b) { return std::array{a.x, a.y, a.z} < std::array{b.x, b.y, b.z}; };
  std::map<Vec3, std::size_t, decltype(less)> numbers(less);
  std::vector<std::array<std::size_t, 3>> numbered;
  for (Corners const& corners : triangles) {
    auto& triangle = numbered.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) triangle[i] = numbers.emplace(corners[i], numbers.size()).first->second;
  }
  std::vector<std::size_t> part(numbers.size());
  std::iota(part.begin(), part.end(), std::size_t(0));
  auto const part_of = [&](std::size_t corner) {
    while (part[corner] != corner) corner = part[corner] = part[part[corner]];
    return corner;
  };
  std::map<std::pair<std::size_t, std::size_t>, int> balance;  // of an edge: how often one way, less the other
  for (auto const& triangle : numbered) {
    for (std::size_t i = 0; i < 3; ++i) {
      std::size_t const a = triangle[i], b = triangle[(i + 1) % 3];
      part[part_of(a)] = part_of(b);
      if (a != b) balance[std::minmax(a, b)] += a < b ? 1 : -1;
    }
  }
  std::vector<bool> is_open(numbers.size());
  for (auto const& [edge, ways] : balance) {
    if (ways != 0) is_open[part_of(edge.first)] = true;
  }
  std::vector<Corners> closed;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (!is_open[part_of(numbered[i][0])]) closed.push_back(triangles[i]);
  }
  return closed;
}

}  // namespace lichtraum::test
