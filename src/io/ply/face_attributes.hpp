#pragma once

#include <optional>
#include <span>

#include "lichtraum/mesh_geometry.hpp"

namespace lichtraum::ply {

/// A vertex or a picture that is not there.
inline constexpr std::uint32_t no_number = 0xFFFFFFFF;

/// What faces say besides their vertices. It is kept for each of the triangles that they are cut into; without a value,
/// the vertices' own counts. A list that no face has is empty.
struct FaceAttributes {
  bool has_texcoords = false;
  bool has_colors = false;
  bool has_pictures = false;
  std::vector<std::optional<Float2>> texcoords;  ///< three per triangle
  std::vector<std::optional<Float4>> colors;     ///< one per triangle
  std::vector<std::uint32_t> pictures;           ///< one per triangle; any number may be there

  /// Makes room, without values, for what says nothing of these: strips.
  void resize(std::size_t triangle_count);
};

/// The geometry of some triangles, given by their numbers, with what their faces say: where faces that meet at a vertex
/// say different things, each has a vertex of its own. A corner that is no vertex of `shared` becomes no_number.
MeshGeometry own_corners(MeshGeometry const& shared, FaceAttributes const& faces,
                         std::span<std::uint32_t const> triangles, bool with_colors);

}  // namespace lichtraum::ply
