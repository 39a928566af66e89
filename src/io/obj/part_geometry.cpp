#include "io/obj/part_geometry.hpp"

#include <algorithm>
#include <utility>

#include "core/srgb.hpp"
#include "io/distinct_keys.hpp"
#include "io/model_scene.hpp"

namespace lichtraum::obj {

PartGeometry::PartGeometry(ObjFile const& file)
    : file_(file), vertex_of_position_(file.positions.size(), Corner::none) {
  for (Float3 const& c : file.colors) {
    Float3& linear = linear_colors_.emplace_back();  // files have what a screen shows
    for (std::size_t i = 0; i < 3; ++i) linear[i] = float(linear_from_srgb(double(c[i])));
  }
}

std::shared_ptr<MeshGeometry const> PartGeometry::of(Part const& part, bool has_picture) {
  auto geometry = std::make_shared<MeshGeometry>();
  bool const is_surface = file_.draws == Drawn::triangles;
  bool const has_texcoords = is_surface && std::any_of(part.corners.begin(), part.corners.end(),
                                                       [](auto& c) { return c.texcoord != Corner::none; });
  bool const has_normals = is_surface && std::any_of(part.corners.begin(), part.corners.end(),
                                                     [](auto& c) { return c.normal != Corner::none; });
  with_colors_ = !linear_colors_.empty() && !(has_picture && has_texcoords);
  if (has_texcoords) geometry->texcoords.emplace_back();
  geometry->indices.reserve(part.corners.size());
  if (has_normals || has_texcoords) {
    index_corners(part, *geometry);
  } else {
    index_positions(part, *geometry);
  }
  if (!has_normals) geometry->normals.clear();
  if (file_.draws == Drawn::lines) geometry->lines = std::exchange(geometry->indices, {});
  if (file_.draws == Drawn::points) geometry->indices.clear();  // one number for each of its positions
  return geometry;
}

void PartGeometry::add_vertex(Corner const& corner, MeshGeometry& out) const {
  out.positions.push_back(file_.positions[corner.position]);
  out.normals.push_back(corner.normal == Corner::none ? Float3{0, 0, 0} : file_.normals[corner.normal]);
  if (!out.texcoords.empty()) {
    out.texcoords[0].push_back(corner.texcoord == Corner::none ? Float2{0, 0} : file_.texcoords[corner.texcoord]);
  }
  if (with_colors_) {
    Float3 const& c = linear_colors_[corner.position];
    out.colors.push_back({c[0], c[1], c[2], 1});
  }
}

void PartGeometry::index_positions(Part const& part, MeshGeometry& out) {
  for (Corner const& corner : part.corners) {
    std::uint32_t& vertex = vertex_of_position_[corner.position];
    if (vertex == Corner::none) {
      vertex = std::uint32_t(out.positions.size());
      add_vertex(corner, out);
    }
    out.indices.push_back(vertex);
  }
  for (Corner const& corner : part.corners) vertex_of_position_[corner.position] = Corner::none;
}

void PartGeometry::index_corners(Part const& part, MeshGeometry& out) {
  DistinctKeys<3> vertices(part.corners.size());
  for (Corner const& corner : part.corners) {
    auto const [vertex, is_new] = vertices.number_of({corner.position, corner.texcoord, corner.normal});
    if (is_new) add_vertex(corner, out);
    out.indices.push_back(vertex);
  }
}

}  // namespace lichtraum::obj
