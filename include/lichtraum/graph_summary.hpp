#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "lichtraum/api.hpp"
#include "lichtraum/shape.hpp"

namespace LICHTRAUM_API lichtraum {

/// How many shapes there are of each kind, and how many triangles, points and lines the meshes, point clouds and line
/// sets have. At most `uncountable` each.
struct ShapeCounts {
  static constexpr std::uint64_t uncountable = std::uint64_t(1) << 62;

  std::array<std::uint64_t, shape_kind_count> of_kind{};
  std::uint64_t mesh_triangles = 0;
  std::uint64_t points = 0;
  std::uint64_t lines = 0;
  std::uint64_t line_ends = 0;  ///< balls: one where lines meet

  std::uint64_t operator[](ShapeKind kind) const { return of_kind[std::size_t(kind)]; }
  /// Everything that a ray may meet: shapes that hold no others, the triangles of meshes, the points of point clouds,
  /// and lines with their ends.
  std::uint64_t primitives() const;
};

/// What a scene graph comes to.
struct GraphSummary {
  ShapeCounts defined;  ///< each shape that can be reached, once
  ShapeCounts drawn;    ///< once for each path from a root: with all instances
  /// Around all that is drawn and has an end, in the world: not around planes. A composite's box is the box around its
  /// children's boxes: where those are turned it may be larger than its contents.
  Bounds bounds;
};

/// Linear in the size of the graph, however many instances it unfolds to.
GraphSummary summarise(std::vector<std::shared_ptr<Shape const>> const& roots);

/// The materials of all shapes that can be reached, each once.
std::vector<std::shared_ptr<Material const>> materials_of(std::vector<std::shared_ptr<Shape const>> const& roots);

}  // namespace lichtraum
