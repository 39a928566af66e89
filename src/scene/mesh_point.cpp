#include "scene/mesh_point.hpp"

#include "scene/graph_order.hpp"
#include "scene/texture_lookup.hpp"

namespace lichtraum {

namespace {

glm::dvec4 to_dvec4(Float4 const& v) { return {v[0], v[1], v[2], v[3]}; }

}  // namespace

MeshPoint::MeshPoint(Hit const& hit) {
  if (Mesh const* const mesh = as_mesh(*hit.shape)) {
    geometry_ = mesh->geometry().get();
    first_index_ = 3 * hit.triangle;
    weights_ = hit.barycentric;
  } else if (PointCloud const* const cloud = as_point_cloud(*hit.shape)) {
    auto const& colors = cloud->geometry()->colors;
    if (!colors.empty()) own_color_ = to_dvec4(colors[hit.triangle]);
  } else if (LineSet const* const set = as_line_set(*hit.shape)) {
    auto const& colors = set->geometry()->colors;
    std::uint32_t const* const ends = set->geometry()->lines.data() + 2 * hit.triangle;
    if (!colors.empty()) {
      own_color_ = hit.barycentric.x * to_dvec4(colors[ends[0]]) + hit.barycentric.y * to_dvec4(colors[ends[1]]);
    }
  }
}

template <class Element>
Element MeshPoint::interpolate(std::vector<std::array<float, Element::length()>> const& values) const {
  Element result(0);
  for (int corner = 0; corner < 3; ++corner) {
    auto const& value = values[geometry_->indices[first_index_ + std::size_t(corner)]];
    for (int i = 0; i < Element::length(); ++i) result[i] += weights_[corner] * double(value[std::size_t(i)]);
  }
  return result;
}

bool MeshPoint::has(int set) const {
  return geometry_ && set >= 0 && std::size_t(set) < geometry_->texcoords.size() &&
         !geometry_->texcoords[std::size_t(set)].empty();
}

glm::dvec4 MeshPoint::color() const {
  if (own_color_) return *own_color_;
  return has_colors() ? interpolate<glm::dvec4>(geometry_->colors) : glm::dvec4(1);
}

std::optional<Vec3> MeshPoint::normal() const {
  if (!geometry_ || geometry_->normals.empty()) return std::nullopt;
  return interpolate<Vec3>(geometry_->normals);
}

std::optional<std::array<MeshPoint::Corner, 3>> MeshPoint::smooth_corners() const {
  if (!geometry_ || geometry_->normals.empty()) return std::nullopt;
  auto const positions = geometry_->triangle(first_index_ / 3);
  Vec3 const point = weights_.x * positions[0] + weights_.y * positions[1] + weights_.z * positions[2];
  std::array<Corner, 3> corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    auto const& normal = geometry_->normals[geometry_->indices[first_index_ + i]];
    corners[i] = {point - positions[i], {normal[0], normal[1], normal[2]}, weights_[int(i)]};
  }
  return corners;
}

std::optional<glm::dvec4> MeshPoint::tangent() const {
  if (!geometry_ || geometry_->tangents.empty()) return std::nullopt;
  return interpolate<glm::dvec4>(geometry_->tangents);
}

std::optional<glm::dvec2> MeshPoint::texcoord(int set) const {
  if (!has(set)) return std::nullopt;
  return interpolate<glm::dvec2>(geometry_->texcoords[std::size_t(set)]);
}

std::optional<MeshPoint::TextureAxes> MeshPoint::texture_axes(TextureSlot const& slot) const {
  if (!has(slot.texcoord)) return std::nullopt;
  auto const corners = geometry_->triangle(first_index_ / 3);
  glm::dvec2 uv[3];
  for (std::size_t i = 0; i < 3; ++i) {
    auto const& stored = geometry_->texcoords[std::size_t(slot.texcoord)][geometry_->indices[first_index_ + i]];
    uv[i] = transform_coordinate(slot, {stored[0], stored[1]});
  }
  glm::dvec2 const uv_ab = uv[1] - uv[0], uv_ac = uv[2] - uv[0];
  Vec3 const ab = corners[1] - corners[0], ac = corners[2] - corners[0];
  double const area = uv_ab.x * uv_ac.y - uv_ab.y * uv_ac.x;
  if (area == 0) return std::nullopt;
  double const side = area < 0 ? -1 : 1;
  return TextureAxes{side * (uv_ac.y * ab - uv_ab.y * ac), side * (uv_ab.x * ac - uv_ac.x * ab)};
}

}  // namespace lichtraum
