#pragma once

#include <optional>

#include "lichtraum/pbr_model.hpp"
#include "lichtraum/shapes.hpp"

namespace lichtraum {

/// What the vertices of a mesh give the point of a hit, in the mesh's own frame; of a point cloud, its point's colour;
/// of a line, the colour between its ends'; of any other shape, nothing.
class MeshPoint {
 public:
  MeshPoint() = default;
  explicit MeshPoint(Hit const& hit);

  bool is_on_mesh() const { return geometry_ != nullptr; }
  bool has_colors() const { return own_color_.has_value() || (geometry_ && !geometry_->colors.empty()); }
  glm::dvec4 color() const;            ///< all ones without
  std::optional<Vec3> normal() const;  ///< of any length

  /// Of a triangle whose vertices have normals.
  struct Corner {
    Vec3 to_point;
    Vec3 normal;  ///< of any length
    double weight;
  };
  std::optional<std::array<Corner, 3>> smooth_corners() const;

  std::optional<glm::dvec4> tangent() const;
  std::optional<glm::dvec2> texcoord(int set) const;

  /// How the point moves with a slot's picture: along u, and along v; of any length, but never mirrored. Nothing where
  /// the picture has no extent on this triangle.
  struct TextureAxes {
    Vec3 along_u;
    Vec3 along_v;
  };
  std::optional<TextureAxes> texture_axes(TextureSlot const& slot) const;

 private:
  template <class Element>
  Element interpolate(std::vector<std::array<float, Element::length()>> const& values) const;
  bool has(int set) const;

  MeshGeometry const* geometry_ = nullptr;
  std::optional<glm::dvec4> own_color_;  ///< of a point in a point cloud, or on a line
  std::size_t first_index_ = 0;
  Vec3 weights_{0};
};

}  // namespace lichtraum
