#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "lichtraum/mesh_geometry.hpp"

namespace lichtraum {

/// Appends the triangles of a polygon as numbers of its corners, in the polygon's sense of rotation: corners.size() - 2
/// of them. Concave polygons of up to 256 corners are cut along their inside (by ears: Meisters 1975), others into a
/// fan. Fewer than three corners give none.
void triangulate(std::span<Float3 const> corners, std::vector<std::array<std::uint32_t, 3>>& triangles);

}  // namespace lichtraum
