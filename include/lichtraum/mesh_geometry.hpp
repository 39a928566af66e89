#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "lichtraum/api.hpp"
#include "lichtraum/bounds.hpp"
#include "lichtraum/math.hpp"

namespace LICHTRAUM_API lichtraum {

using Float2 = std::array<float, 2>;
using Float3 = std::array<float, 3>;
using Float4 = std::array<float, 4>;

/// Triangles and what is needed to shade them, in single precision and in a frame of their own. Every Mesh that shows
/// them shares them, so an instance costs no copy. An attribute list is empty or has one element for each position.
/// What holds no triangles may be points (a PointCloud), or lines (a LineSet).
struct MeshGeometry {
  std::vector<Float3> positions;
  std::vector<std::uint32_t> indices;  ///< three per triangle, into the attributes; counter-clockwise seen from outside
  std::vector<std::uint32_t> lines;    ///< two per line, into the attributes; what a Mesh shows does not depend on them

  std::vector<Float3> normals;                 ///< unit length, outward; empty: flat, as the triangles lie
  std::vector<Float4> tangents;                ///< xyz unit length, w = +1 or -1: the sign of the bitangent
  std::vector<std::vector<Float2>> texcoords;  ///< sets 0..n; (0, 0) is the image's first texel, the top left one
  std::vector<Float4> colors;  ///< linear red, green, blue and alpha, times the base colour of a Material::pbr

  std::size_t triangle_count() const { return indices.size() / 3; }
  std::array<Vec3, 3> triangle(std::size_t number) const;
  /// Around the corners of its triangles, or, without any, its positions: those that are finite.
  Bounds bounds() const;
};

}  // namespace lichtraum
