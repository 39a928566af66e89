#include "scene/bake_attributes.hpp"

#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>

#include "core/float3.hpp"
#include "core/huge_pages.hpp"
#include "core/parallel_ranges.hpp"
#include "lichtraum/error.hpp"
#include "scene/pbr_evaluation.hpp"
#include "scene/used_texcoords.hpp"

namespace lichtraum {
namespace {

/// What is kept of a mesh's vertices.
struct VertexLayout {
  device::uint format = 0;
  std::vector<std::vector<Float2> const*> texcoords;  ///< in the order of the format's bits
  std::size_t floats = 0;                             ///< a vertex
};

VertexLayout layout_of(MeshGeometry const& geometry, Material const* material) {
  VertexLayout layout;
  PbrModel const* const pbr = material ? material->pbr() : nullptr;
  bool const is_unlit = pbr && pbr->unlit;
  if (!geometry.normals.empty() && !is_unlit) {
    layout.format |= VERTEX_NORMAL;
    layout.floats += 3;
  }
  if (!pbr) return layout;
  if (!geometry.tangents.empty() && !is_unlit && (pbr->normal_texture || needs_tangents(*pbr))) {
    layout.format |= VERTEX_TANGENT;
    layout.floats += 4;
  }
  if (!geometry.colors.empty()) {
    layout.format |= VERTEX_COLOR;
    layout.floats += 4;
  }
  std::vector<int> const sets = used_texcoords(*pbr);
  for (std::size_t k = 0; k < std::min<std::size_t>(sets.size(), VERTEX_MAX_TEXCOORDS); ++k) {
    bool const exists = sets[k] >= 0 && std::size_t(sets[k]) < geometry.texcoords.size() &&
                        !geometry.texcoords[std::size_t(sets[k])].empty();
    if (!exists) continue;
    layout.format |= 1u << (VERTEX_TEXCOORD_SHIFT + k);
    layout.texcoords.push_back(&geometry.texcoords[std::size_t(sets[k])]);
    layout.floats += 2;
  }
  return layout;
}

/// The matrix, scaled so that its largest element is 1: neither tiny nor huge maps leave the range of floats.
Mat3 scaled_to_one(Mat3 const& m) {
  double largest = 0;
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) largest = std::max(largest, std::abs(m[column][row]));
  }
  return largest > 0 && std::isfinite(largest) ? m / largest : m;
}

template <std::size_t N>
float* write(std::array<float, N> const& values, float* out) {
  return std::copy(values.begin(), values.end(), out);
}
float* write(Vec3 const& v, float* out) {
  for (int axis = 0; axis < 3; ++axis) *out++ = float(v[axis]);
  return out;
}

void append_vertices(MeshGeometry const& geometry, VertexLayout const& layout, Transform const& object_from_mesh,
                     BigVector<float>& data) {
  Mat3 const normals = scaled_to_one(glm::transpose(Mat3(object_from_mesh.inverse_matrix())));
  Mat3 const vectors = scaled_to_one(Mat3(object_from_mesh.matrix()));
  float const handedness = glm::determinant(vectors) < 0 ? -1.0f : 1.0f;
  std::size_t const first = data.size();
  reserve_in_huge_pages(data, first + layout.floats * geometry.positions.size());
  data.resize(first + layout.floats * geometry.positions.size());
  for_parallel_ranges(geometry.positions.size(), min_elements_of_thread, [&](std::size_t begin, std::size_t end) {
    float* out = data.data() + first + layout.floats * begin;
    for (std::size_t i = begin; i < end; ++i) {
      if (layout.format & VERTEX_NORMAL) {
        Float3 const& n = geometry.normals[i];
        out = write(normals * Vec3(n[0], n[1], n[2]), out);
      }
      if (layout.format & VERTEX_TANGENT) {
        Float4 const& t = geometry.tangents[i];
        out = write(vectors * Vec3(t[0], t[1], t[2]), out);
        *out++ = handedness * t[3];
      }
      if (layout.format & VERTEX_COLOR) out = write(geometry.colors[i], out);
      for (auto const* texcoords : layout.texcoords) out = write((*texcoords)[i], out);
    }
  });
}

void check_float_count(std::size_t count) {
  if (count <= 0xFFFFFFFFu) return;
  throw Error(ErrorKind::scene, "the meshes' normals, colours and texture coordinates need more than 2^32 floats");
}

}  // namespace

void bake_attributes(Mesh const& mesh, Transform const& object_from_mesh, std::vector<Float3> const& positions,
                     std::size_t const (&places)[3], std::size_t first, FlatObject& object) {
  MeshGeometry const& geometry = *mesh.geometry();
  VertexLayout const layout = layout_of(geometry, mesh.material().get());
  if (layout.format == 0) return;
  std::size_t const first_float = object.vertex_data.size();
  check_float_count(first_float + layout.floats * geometry.positions.size());
  append_vertices(geometry, layout, object_from_mesh, object.vertex_data);

  reserve_in_huge_pages(object.triangle_attributes, object.triangles.size());
  object.triangle_attributes.resize(object.triangles.size(), {});
  device::TriangleAttributes* const attributes = object.triangle_attributes.data() + first;
  auto const write_triangle = [&](std::size_t i, device::TriangleAttributes& out) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      out.corners[places[corner]] = device::uint(first_float + layout.floats * geometry.indices[3 * i + corner]);
    }
    out.format = layout.format;
  };
  if (object.triangles.size() - first == geometry.triangle_count()) {
    for_parallel_ranges(geometry.triangle_count(), min_elements_of_thread, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) write_triangle(i, attributes[i]);
    });
    return;
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < geometry.triangle_count(); ++i) {
    auto const is_kept = [&](std::size_t corner) { return is_finite(positions[geometry.indices[3 * i + corner]]); };
    if (is_kept(0) && is_kept(1) && is_kept(2)) write_triangle(i, attributes[kept++]);
  }
}

void bake_colors(MeshGeometry const& geometry, Material const* material, std::vector<std::uint32_t> const& vertices,
                 std::size_t each, std::size_t count, BigVector<device::uint>& colors, FlatObject& object) {
  if (geometry.colors.empty() || !material || !material->pbr()) return;
  std::size_t const first_float = object.vertex_data.size();
  check_float_count(first_float + 4 * vertices.size() + 1);
  reserve_in_huge_pages(object.vertex_data, first_float + 4 * vertices.size());
  reserve_in_huge_pages(colors, count);
  colors.resize(count - vertices.size() / each, 0);
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (i % each == 0) colors.push_back(device::uint(object.vertex_data.size() + 1));
    Float4 const& color = geometry.colors[vertices[i]];
    object.vertex_data.insert(object.vertex_data.end(), color.begin(), color.end());
  }
}

}  // namespace lichtraum
