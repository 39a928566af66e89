#include "io/gltf/primitives.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "io/faulty_geometry.hpp"
#include "io/gltf/draco.hpp"
#include "io/gltf/values.hpp"
#include "io/lines.hpp"
#include "io/triangles.hpp"

namespace lichtraum::gltf {
namespace {

constexpr char const* draco_extension = "KHR_draco_mesh_compression";

template <std::size_t N>
std::vector<std::array<float, N>> to_vectors(FloatElements const& elements) {
  std::vector<std::array<float, N>> result(elements.count());
  for (std::size_t i = 0; i < result.size(); ++i) {
    std::copy_n(elements.values.data() + i * N, N, result[i].begin());
  }
  return result;
}

/// Sets what is not a number to zero: shading then falls back to the triangle's own normal.
template <std::size_t N>
void remove_non_finite(std::vector<std::array<float, N>>& vectors) {
  for (auto& v : vectors) {
    if (!std::all_of(v.begin(), v.end(), [](float x) { return std::isfinite(x); })) v.fill(0);
  }
}

}  // namespace

/// A primitive while it is read.
struct Primitives::Source {
  tinygltf::Primitive const& primitive;
  std::string pointer;
  std::optional<DracoPrimitive> draco = std::nullopt;

  int accessor(std::string const& name) const {
    auto const found = primitive.attributes.find(name);
    return found == primitive.attributes.end() ? -1 : found->second;
  }
  std::string place(std::string const& name) const { return pointer + "/attributes/" + name; }
  bool has(std::string const& name) const { return accessor(name) >= 0 || (draco && draco->attributes.contains(name)); }
};

std::optional<Primitive> Primitives::read(int mesh, std::size_t number) {
  auto const& source_primitive = document_.model.meshes[std::size_t(mesh)].primitives[number];
  Source source{source_primitive, fmt::format("/meshes/{}/primitives/{}", mesh, number)};
  if (source_primitive.mode > 6) {
    findings_.warn(DiagnosticCode::undrawn_primitive, source.pointer + "/mode",
                   fmt::format("glTF has no mode {}", source_primitive.mode));
    return std::nullopt;
  }

  std::string key = fmt::format("{} {}", source_primitive.mode, source_primitive.indices);
  for (auto const& [name, accessor] : source_primitive.attributes) key += fmt::format(" {} {}", name, accessor);
  if (auto const* draco = find_extension(source_primitive.extensions, draco_extension)) {
    key += fmt::format(" draco {}", number_of(*draco, "bufferView", -1));
  }
  auto const known = known_.find(key);
  Primitive result;
  result.material = source_primitive.material;
  if (known != known_.end()) {
    result.geometry = known->second;
  } else {
    result.geometry = read_geometry(source);
    known_.emplace(key, result.geometry);
  }
  if (!result.geometry) return std::nullopt;
  std::size_t const count = result.geometry->positions.size();
  result.targets = read_targets(source, count);
  if (source.accessor("JOINTS_0") >= 0) {
    if (!source.draco) decompress(source);  // the geometry was known
    result.joint_sets = read_joint_sets(source, count);
  }
  return result;
}

bool Primitives::decompress(Source& source) {
  auto const* parameters = find_extension(source.primitive.extensions, draco_extension);
  if (!parameters) return true;
  std::string const pointer = fmt::format("{}/extensions/{}", source.pointer, draco_extension);
  auto const view = index_of(*parameters, "bufferView", document_.model.bufferViews.size());
  if (!view || !parameters->Has("attributes") || !parameters->Get("attributes").IsObject()) {
    findings_.warn(DiagnosticCode::unreadable_accessor, pointer,
                   "bufferView or attributes are missing or out of range");
    return source.primitive.attributes.empty();
  }
  std::map<std::string, DracoAttribute> wanted;
  tinygltf::Value const& attributes = parameters->Get("attributes");
  for (std::string const& name : attributes.Keys()) {
    DracoAttribute attribute{int(number_of(attributes, name.c_str(), -1)), std::nullopt};
    int const accessor = source.accessor(name);
    if (accessor >= 0) attribute.is_normalized = accessors_.is_normalized(accessor);
    wanted.emplace(name, attribute);
  }
  std::string reason = "nothing could be read from its buffer view";
  if (auto const bytes = buffers_.view(*view)) {
    reason.clear();
    source.draco = decode_draco(*bytes, wanted, reason);
  }
  if (!reason.empty()) findings_.warn(DiagnosticCode::unreadable_accessor, pointer, reason);
  return source.draco.has_value();
}

template <std::size_t N>
std::vector<std::array<float, N>> Primitives::read_attribute(Source const& source, std::string const& name,
                                                             std::size_t count) {
  if (!source.has(name)) return {};
  std::vector<std::array<float, N>> result;
  if (source.draco && source.draco->attributes.contains(name)) {
    FloatElements const& elements = source.draco->attributes.at(name);
    if (elements.components != N) {
      findings_.warn(DiagnosticCode::unreadable_accessor, source.place(name),
                     fmt::format("{} components where {} are expected", elements.components, N));
      return {};
    }
    result = to_vectors<N>(elements);
  } else if (auto vectors = accessors_.vectors<N>(source.accessor(name), source.place(name))) {
    result = std::move(*vectors);
  }
  if (count != 0 && !result.empty() && result.size() != count) {
    findings_.warn(DiagnosticCode::unreadable_accessor, source.place(name),
                   fmt::format("{} elements for {} positions", result.size(), count));
    if (result.size() < count) return {};
    result.resize(count);
  }
  return result;
}

std::vector<Float4> Primitives::read_colors(Source const& source, std::size_t count) {
  std::string const name = "COLOR_0";
  if (!source.has(name)) return {};
  bool const is_draco = source.draco && source.draco->attributes.contains(name);
  std::optional<FloatElements> const elements =
      is_draco ? source.draco->attributes.at(name) : accessors_.floats(source.accessor(name), 0, source.place(name));
  if (!elements) return {};
  if ((elements->components != 3 && elements->components != 4) || elements->count() < count) {
    findings_.warn(
        DiagnosticCode::unreadable_accessor, source.place(name),
        fmt::format("{} elements of {} components for {} positions", elements->count(), elements->components, count));
    return {};
  }
  std::vector<Float4> colors(count, Float4{0, 0, 0, 1});
  for (std::size_t i = 0; i < count; ++i) {
    std::copy_n(elements->values.data() + i * elements->components, elements->components, colors[i].begin());
  }
  remove_non_finite(colors);
  return colors;
}

std::optional<std::vector<std::uint32_t>> Primitives::read_indices(Source const& source, std::size_t vertex_count) {
  if (source.draco) return source.draco->indices;
  std::vector<std::uint32_t> indices;
  if (source.primitive.indices >= 0) {
    auto read = accessors_.integers(source.primitive.indices, 1, source.pointer + "/indices");
    if (!read) return std::nullopt;
    indices = std::move(*read);
  } else {
    indices.resize(vertex_count);
    for (std::size_t i = 0; i < vertex_count; ++i) indices[i] = std::uint32_t(i);
  }
  return indices;
}

std::shared_ptr<MeshGeometry const> Primitives::read_geometry(Source& source) {
  if (!decompress(source)) return nullptr;
  if (!source.has("POSITION")) {
    findings_.warn(DiagnosticCode::undrawn_primitive, source.pointer + "/attributes", "POSITION is missing");
    return nullptr;
  }
  auto geometry = std::make_shared<MeshGeometry>();
  geometry->positions = read_attribute<3>(source, "POSITION", 0);
  if (geometry->positions.empty()) return nullptr;
  if (source.primitive.mode == TINYGLTF_MODE_POINTS) return read_points(source, std::move(geometry));
  if (source.primitive.mode <= TINYGLTF_MODE_LINE_STRIP) return read_lines(source, std::move(geometry));
  std::size_t const count = geometry->positions.size();
  auto indices = read_indices(source, count);
  if (!indices) return nullptr;
  geometry->indices = source.draco ? std::move(*indices) : to_triangle_list(std::move(*indices), source.primitive.mode);

  geometry->normals = read_attribute<3>(source, "NORMAL", count);
  remove_non_finite(geometry->normals);
  if (!geometry->normals.empty()) geometry->tangents = read_attribute<4>(source, "TANGENT", count);
  remove_non_finite(geometry->tangents);
  for (int set = 0; source.has(fmt::format("TEXCOORD_{}", set)); ++set) {
    geometry->texcoords.push_back(read_attribute<2>(source, fmt::format("TEXCOORD_{}", set), count));
    remove_non_finite(geometry->texcoords.back());
  }
  geometry->colors = read_colors(source, count);

  return remove_faulty_parts(source, geometry->indices, 3, "triangle", geometry->positions) ? geometry : nullptr;
}

bool Primitives::remove_faulty_parts(Source const& source, std::vector<std::uint32_t>& indices, std::size_t corners,
                                     char const* noun, std::vector<Float3> const& positions) {
  GeometryFaults const faults = remove_faulty(indices, corners, positions);
  if (faults.out_of_range > 0) {
    findings_.warn(DiagnosticCode::geometry_left_out, source.pointer + "/indices",
                   left_out_message(faults.out_of_range,
                                    fmt::format("an index that is out of range ({})", positions.size()), noun));
  }
  if (faults.non_finite > 0) {
    findings_.warn(DiagnosticCode::geometry_left_out, source.place("POSITION"),
                   left_out_message(faults.non_finite, "a vertex that is not finite", noun));
  }
  if (indices.empty() && faults.out_of_range + faults.non_finite == 0) {
    findings_.warn(DiagnosticCode::undrawn_primitive, source.pointer, fmt::format("it holds no {}", noun));
  }
  return !indices.empty();
}

std::shared_ptr<MeshGeometry const> Primitives::read_points(Source const& source,
                                                            std::shared_ptr<MeshGeometry> geometry) {
  geometry->colors = read_colors(source, geometry->positions.size());
  auto const is_finite = [](Float3 const& p) { return std::isfinite(p[0] + p[1] + p[2]); };
  auto const finite = std::count_if(geometry->positions.begin(), geometry->positions.end(), is_finite);
  if (std::size_t const lost = geometry->positions.size() - std::size_t(finite); lost > 0) {
    findings_.warn(DiagnosticCode::geometry_left_out, source.place("POSITION"),
                   fmt::format("points that are not finite are left out: {}", lost));
  }
  if (finite == 0) return nullptr;
  if (source.primitive.indices < 0) return geometry;
  auto const indices = accessors_.integers(source.primitive.indices, 1, source.pointer + "/indices");
  if (!indices) return nullptr;
  // What no index names is put where nothing is drawn: morph targets and joints count all positions.
  std::vector<bool> is_named(geometry->positions.size(), false);
  std::size_t out_of_range = 0;
  for (std::uint32_t const index : *indices) {
    if (index < is_named.size()) {
      is_named[index] = true;
    } else {
      ++out_of_range;
    }
  }
  if (out_of_range > 0) {
    findings_.warn(DiagnosticCode::geometry_left_out, source.pointer + "/indices",
                   fmt::format("points left out whose index is out of range ({}): {}", is_named.size(), out_of_range));
  }
  for (std::size_t i = 0; i < is_named.size(); ++i) {
    if (!is_named[i]) geometry->positions[i].fill(std::numeric_limits<float>::quiet_NaN());
  }
  return geometry;
}

std::shared_ptr<MeshGeometry const> Primitives::read_lines(Source const& source,
                                                           std::shared_ptr<MeshGeometry> geometry) {
  std::size_t const count = geometry->positions.size();
  geometry->colors = read_colors(source, count);
  auto indices = read_indices(source, count);
  if (!indices) return nullptr;
  geometry->lines = to_line_list(std::move(*indices), source.primitive.mode);
  return remove_faulty_parts(source, geometry->lines, 2, "line", geometry->positions) ? geometry : nullptr;
}

std::vector<MorphTarget> Primitives::read_targets(Source const& source, std::size_t count) {
  std::vector<MorphTarget> targets;
  for (std::size_t i = 0; i < source.primitive.targets.size(); ++i) {
    auto const& attributes = source.primitive.targets[i];
    auto const read = [&](char const* name) -> std::vector<Float3> {
      auto const found = attributes.find(name);
      if (found == attributes.end()) return {};
      std::string const place = fmt::format("{}/targets/{}/{}", source.pointer, i, name);
      auto vectors = accessors_.vectors<3>(found->second, place);
      if (!vectors) return {};
      if (vectors->size() != count) {
        findings_.warn(DiagnosticCode::unreadable_accessor, place,
                       fmt::format("{} elements for {} positions", vectors->size(), count));
        return {};
      }
      remove_non_finite(*vectors);
      return std::move(*vectors);
    };
    targets.push_back({read("POSITION"), read("NORMAL"), read("TANGENT")});
  }
  return targets;
}

std::vector<JointSet> Primitives::read_joint_sets(Source const& source, std::size_t count) {
  std::vector<JointSet> sets;
  for (int set = 0; source.has(fmt::format("JOINTS_{}", set)); ++set) {
    JointSet result;
    result.weights = read_attribute<4>(source, fmt::format("WEIGHTS_{}", set), count);
    std::string const name = fmt::format("JOINTS_{}", set);
    std::vector<Float4> const joints = read_attribute<4>(source, name, count);
    if (joints.size() != count || result.weights.size() != count) {
      findings_.warn(DiagnosticCode::unreadable_accessor, source.place(name), "joints or weights cannot be read");
      break;
    }
    remove_non_finite(result.weights);
    result.joints.reserve(count);
    for (Float4 const& j : joints) {  // no more than 65535: exact as floats
      auto const index = [](float v) { return v >= 0 && v <= 65535 ? std::uint32_t(v) : 0; };
      result.joints.push_back({index(j[0]), index(j[1]), index(j[2]), index(j[3])});
    }
    sets.push_back(std::move(result));
  }
  return sets;
}

}  // namespace lichtraum::gltf
