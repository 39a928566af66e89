#include "io/ply/face_attributes.hpp"

#include <bit>

#include "io/distinct_keys.hpp"

namespace lichtraum::ply {

void FaceAttributes::resize(std::size_t triangle_count) {
  if (has_texcoords) texcoords.resize(3 * triangle_count);
  if (has_colors) colors.resize(triangle_count);
  if (has_pictures) pictures.resize(triangle_count, no_number);
}

MeshGeometry own_corners(MeshGeometry const& shared, FaceAttributes const& faces,
                         std::span<std::uint32_t const> triangles, bool with_colors) {
  auto const texcoord_of = [&](std::size_t corner, std::uint32_t vertex) {
    if (faces.has_texcoords && faces.texcoords[corner]) return *faces.texcoords[corner];
    return shared.texcoords.empty() ? Float2{0, 0} : shared.texcoords[0][vertex];
  };
  auto const color_of = [&](std::size_t triangle, std::uint32_t vertex) {
    if (faces.has_colors && faces.colors[triangle]) return *faces.colors[triangle];
    return shared.colors.empty() ? Float4{1, 1, 1, 1} : shared.colors[vertex];
  };
  MeshGeometry own;
  bool const has_texcoords = faces.has_texcoords || !shared.texcoords.empty();
  bool const has_colors = with_colors && (faces.has_colors || !shared.colors.empty());
  if (has_texcoords) own.texcoords.emplace_back();
  own.indices.reserve(3 * triangles.size());
  DistinctKeys<7> vertices(3 * triangles.size());
  for (std::uint32_t const triangle : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      std::size_t const corner = 3 * std::size_t(triangle) + k;
      std::uint32_t const vertex = shared.indices[corner];
      if (vertex >= shared.positions.size()) {
        own.indices.push_back(no_number);
        continue;
      }
      Float2 const uv = has_texcoords ? texcoord_of(corner, vertex) : Float2{};
      Float4 const color = has_colors ? color_of(triangle, vertex) : Float4{};
      auto const word = [](float value) { return std::bit_cast<std::uint32_t>(value); };
      auto const [number, is_new] = vertices.number_of(
          {vertex, word(uv[0]), word(uv[1]), word(color[0]), word(color[1]), word(color[2]), word(color[3])});
      own.indices.push_back(number);
      if (!is_new) continue;
      own.positions.push_back(shared.positions[vertex]);
      if (!shared.normals.empty()) own.normals.push_back(shared.normals[vertex]);
      if (has_texcoords) own.texcoords[0].push_back(uv);
      if (has_colors) own.colors.push_back(color);
    }
  }
  return own;
}

}  // namespace lichtraum::ply
