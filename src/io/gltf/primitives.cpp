#include "io/gltf/primitives.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

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

std::uint64_t bytes_of(DracoPrimitive const& primitive) {
  std::uint64_t numbers = primitive.indices.size();
  for (auto const& [name, elements] : primitive.attributes) numbers += elements.values.size();
  return numbers * sizeof(float);
}

/// Of a vertex buffer that many primitives share, each names a small part: keeps only that part, and makes `indices`
/// count in it. The numbers of the vertices kept, ascending; null: all are. Most primitives name each of their vertices
/// several times, so the first look ends it.
std::shared_ptr<Accessors::Numbers const> keep_what_is_named(std::vector<std::uint32_t>& indices,
                                                             std::size_t vertex_count) {
  if (indices.size() >= vertex_count) return nullptr;
  Accessors::Numbers kept = indices;
  std::sort(kept.begin(), kept.end());
  kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
  while (!kept.empty() && kept.back() >= vertex_count) kept.pop_back();
  if (kept.empty() || kept.size() > vertex_count / 2) return nullptr;
  for (std::uint32_t& index : indices) {
    auto const found = std::lower_bound(kept.begin(), kept.end(), index);
    bool const is_out_of_range = found == kept.end();
    index = is_out_of_range ? std::numeric_limits<std::uint32_t>::max() : std::uint32_t(found - kept.begin());
  }
  return std::make_shared<Accessors::Numbers const>(std::move(kept));
}

/// Sets what is not a number to zero: shading then falls back to the triangle's own normal.
template <std::size_t N>
void remove_non_finite(std::vector<std::array<float, N>>& vectors) {
  for (auto& v : vectors) {
    if (!std::all_of(v.begin(), v.end(), [](float x) { return std::isfinite(x); })) v.fill(0);
  }
}

/// Of three components or four; `alpha` where there is none.
std::vector<Float4> to_colors(FloatElements const& elements, float alpha) {
  std::vector<Float4> colors(elements.count(), Float4{0, 0, 0, alpha});
  for (std::size_t i = 0; i < colors.size(); ++i) {
    std::copy_n(elements.values.data() + i * elements.components, elements.components, colors[i].begin());
  }
  remove_non_finite(colors);
  return colors;
}

}  // namespace

/// A primitive while it is read.
struct Primitives::Source {
  tinygltf::Primitive const& primitive;
  std::string pointer;
  std::optional<DracoPrimitive> draco = std::nullopt;
  std::vector<std::uint32_t> indices = {};  ///< into what is kept
  std::size_t vertex_count = 0;             ///< of what its accessors hold
  std::shared_ptr<Accessors::Numbers const> kept = nullptr;

  /// Of what is kept.
  std::size_t count() const { return kept ? kept->size() : vertex_count; }
  bool is_indexed() const { return draco || primitive.indices >= 0; }
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
    result.geometry = known->second.geometry;
    source.vertex_count = known->second.vertex_count;
    source.kept = known->second.kept;
  } else {
    result.geometry = read_geometry(source);
    known_.emplace(key, Known{result.geometry, source.vertex_count, source.kept});
  }
  if (!result.geometry) return std::nullopt;
  result.targets = read_targets(source, *result.geometry);
  if (source.accessor("JOINTS_0") >= 0) {
    if (!source.draco) decompress(source);  // the geometry was known
    result.joint_sets = read_joint_sets(source);
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
    if (source.draco) budget_.charge(bytes_of(*source.draco), pointer);
  }
  if (!reason.empty()) findings_.warn(DiagnosticCode::unreadable_accessor, pointer, reason);
  return source.draco.has_value();
}

template <std::size_t N>
std::optional<std::vector<std::array<float, N>>> Primitives::read_vectors(Source const& source, int accessor,
                                                                          std::string const& place) {
  return accessors_.vectors<N>(accessor, place, kept_in(source, accessor));
}

Accessors::Numbers const* Primitives::kept_in(Source const& source, int accessor) const {
  return accessors_.count(accessor) < source.vertex_count ? nullptr : source.kept.get();
}

template <std::size_t N>
std::vector<std::array<float, N>> Primitives::read_attribute(Source const& source, std::string const& name) {
  if (!source.has(name)) return {};
  std::vector<std::array<float, N>> result;
  std::size_t found = 0;
  if (source.draco && source.draco->attributes.contains(name)) {
    FloatElements const& elements = source.draco->attributes.at(name);
    if (elements.components != N) {
      findings_.warn(DiagnosticCode::unreadable_accessor, source.place(name),
                     fmt::format("{} components where {} are expected", elements.components, N));
      return {};
    }
    result = to_vectors<N>(elements);
    found = result.size();
  } else if (auto vectors = read_vectors<N>(source, source.accessor(name), source.place(name))) {
    result = std::move(*vectors);
    found = accessors_.count(source.accessor(name));
  }
  if (!result.empty() && found != source.vertex_count) {
    findings_.warn(DiagnosticCode::unreadable_accessor, source.place(name),
                   fmt::format("{} elements for {} positions", found, source.vertex_count));
    if (found < source.vertex_count) return {};
    result.resize(source.count());
  }
  return result;
}

std::vector<Float4> Primitives::read_colors(Source const& source) {
  std::string const name = "COLOR_0";
  if (!source.has(name)) return {};
  bool const is_draco = source.draco && source.draco->attributes.contains(name);
  int const accessor = source.accessor(name);
  std::optional<FloatElements> const elements =
      is_draco ? source.draco->attributes.at(name)
               : accessors_.floats(accessor, 0, source.place(name), kept_in(source, accessor));
  if (!elements) return {};
  std::size_t const found = is_draco ? elements->count() : accessors_.count(accessor);
  if ((elements->components != 3 && elements->components != 4) || found < source.vertex_count) {
    findings_.warn(
        DiagnosticCode::unreadable_accessor, source.place(name),
        fmt::format("{} elements of {} components for {} positions", found, elements->components, source.vertex_count));
    return {};
  }
  std::vector<Float4> colors = to_colors(*elements, 1);
  colors.resize(source.count());
  return colors;
}

bool Primitives::read_indices(Source& source) {
  if (source.draco) {
    source.indices = std::move(source.draco->indices);
  } else if (source.primitive.indices >= 0) {
    auto read = accessors_.integers(source.primitive.indices, 1, source.pointer + "/indices");
    if (!read) return false;
    source.indices = std::move(*read);
    source.kept = keep_what_is_named(source.indices, source.vertex_count);
  }
  return true;
}

std::vector<std::uint32_t> Primitives::take_indices(Source& source) {
  if (source.is_indexed()) return std::move(source.indices);
  std::vector<std::uint32_t> all(source.vertex_count);
  std::iota(all.begin(), all.end(), 0u);
  return all;
}

std::shared_ptr<MeshGeometry const> Primitives::read_geometry(Source& source) {
  if (!decompress(source)) return nullptr;
  if (!source.has("POSITION")) {
    findings_.warn(DiagnosticCode::undrawn_primitive, source.pointer + "/attributes", "POSITION is missing");
    return nullptr;
  }
  bool const is_draco = source.draco && source.draco->attributes.contains("POSITION");
  source.vertex_count =
      is_draco ? source.draco->attributes.at("POSITION").count() : accessors_.count(source.accessor("POSITION"));
  if (!read_indices(source)) return nullptr;
  auto geometry = std::make_shared<MeshGeometry>();
  geometry->positions = read_attribute<3>(source, "POSITION");
  if (geometry->positions.empty()) return nullptr;
  if (source.primitive.mode == TINYGLTF_MODE_POINTS) return read_points(source, std::move(geometry));
  if (source.primitive.mode <= TINYGLTF_MODE_LINE_STRIP) return read_lines(source, std::move(geometry));
  auto indices = take_indices(source);
  geometry->indices = source.draco ? std::move(indices) : to_triangle_list(std::move(indices), source.primitive.mode);

  geometry->normals = read_attribute<3>(source, "NORMAL");
  remove_non_finite(geometry->normals);
  if (!geometry->normals.empty()) geometry->tangents = read_attribute<4>(source, "TANGENT");
  remove_non_finite(geometry->tangents);
  for (int set = 0; source.has(fmt::format("TEXCOORD_{}", set)); ++set) {
    geometry->texcoords.push_back(read_attribute<2>(source, fmt::format("TEXCOORD_{}", set)));
    remove_non_finite(geometry->texcoords.back());
  }
  geometry->colors = read_colors(source);

  return remove_faulty_parts(source, geometry->indices, 3, "triangle", geometry->positions) ? geometry : nullptr;
}

bool Primitives::remove_faulty_parts(Source const& source, std::vector<std::uint32_t>& indices, std::size_t corners,
                                     char const* noun, std::vector<Float3> const& positions) {
  GeometryFaults const faults = remove_faulty(indices, corners, positions);
  if (faults.out_of_range > 0) {
    findings_.warn(DiagnosticCode::geometry_left_out, source.pointer + "/indices",
                   left_out_message(faults.out_of_range,
                                    fmt::format("an index that is out of range ({})", source.vertex_count), noun));
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
  geometry->colors = read_colors(source);
  auto const is_finite = [](Float3 const& p) { return std::isfinite(p[0] + p[1] + p[2]); };
  auto const finite = std::count_if(geometry->positions.begin(), geometry->positions.end(), is_finite);
  if (std::size_t const lost = geometry->positions.size() - std::size_t(finite); lost > 0) {
    findings_.warn(DiagnosticCode::geometry_left_out, source.place("POSITION"),
                   fmt::format("points that are not finite are left out: {}", lost));
  }
  if (finite == 0) return nullptr;
  if (!source.is_indexed()) return geometry;
  // What no index names is put where nothing is drawn: morph targets and joints count all positions.
  std::vector<bool> is_named(geometry->positions.size(), false);
  std::size_t out_of_range = 0;
  for (std::uint32_t const index : source.indices) {
    if (index < is_named.size()) {
      is_named[index] = true;
    } else {
      ++out_of_range;
    }
  }
  if (out_of_range > 0) {
    findings_.warn(
        DiagnosticCode::geometry_left_out, source.pointer + "/indices",
        fmt::format("points left out whose index is out of range ({}): {}", source.vertex_count, out_of_range));
  }
  for (std::size_t i = 0; i < is_named.size(); ++i) {
    if (!is_named[i]) geometry->positions[i].fill(std::numeric_limits<float>::quiet_NaN());
  }
  return geometry;
}

std::shared_ptr<MeshGeometry const> Primitives::read_lines(Source& source, std::shared_ptr<MeshGeometry> geometry) {
  geometry->colors = read_colors(source);
  geometry->lines = to_line_list(take_indices(source), source.primitive.mode);
  return remove_faulty_parts(source, geometry->lines, 2, "line", geometry->positions) ? geometry : nullptr;
}

template <std::size_t N>
std::vector<std::array<float, N>> Primitives::read_deltas(Source const& source, TargetAttribute const& attribute) {
  if (attribute.accessor < 0) return {};
  auto deltas = read_vectors<N>(source, attribute.accessor, attribute.place);
  if (!deltas || !has_delta_for_each(source, attribute)) return {};
  remove_non_finite(*deltas);
  return std::move(*deltas);
}

std::vector<Float4> Primitives::read_color_deltas(Source const& source, TargetAttribute const& attribute) {
  if (attribute.accessor < 0) return {};
  auto const deltas = accessors_.floats(attribute.accessor, 0, attribute.place, kept_in(source, attribute.accessor));
  if (!deltas || !has_delta_for_each(source, attribute)) return {};
  if (deltas->components != 3 && deltas->components != 4) {
    findings_.warn(DiagnosticCode::unreadable_accessor, attribute.place,
                   fmt::format("{} components where 3 or 4 are expected", deltas->components));
    return {};
  }
  return to_colors(*deltas, 0);
}

bool Primitives::has_delta_for_each(Source const& source, TargetAttribute const& attribute) {
  std::size_t const count = accessors_.count(attribute.accessor);
  if (count == source.vertex_count) return true;
  findings_.warn(DiagnosticCode::unreadable_accessor, attribute.place,
                 fmt::format("{} elements for {} positions", count, source.vertex_count));
  return false;
}

std::vector<MorphTarget> Primitives::read_targets(Source const& source, MeshGeometry const& geometry) {
  std::vector<MorphTarget> targets;
  for (std::size_t i = 0; i < source.primitive.targets.size(); ++i) {
    auto const& attributes = source.primitive.targets[i];
    auto const attribute = [&](std::string const& name) -> TargetAttribute {
      auto const found = attributes.find(name);
      return {found == attributes.end() ? -1 : found->second, fmt::format("{}/targets/{}/{}", source.pointer, i, name)};
    };
    MorphTarget& target = targets.emplace_back();
    target.positions = read_deltas<3>(source, attribute("POSITION"));
    target.normals = read_deltas<3>(source, attribute("NORMAL"));
    target.tangents = read_deltas<3>(source, attribute("TANGENT"));
    for (std::size_t set = 0; set < geometry.texcoords.size(); ++set) {
      target.texcoords.push_back(read_deltas<2>(source, attribute(fmt::format("TEXCOORD_{}", set))));
    }
    if (!geometry.colors.empty()) target.colors = read_color_deltas(source, attribute("COLOR_0"));
  }
  return targets;
}

std::vector<JointSet> Primitives::read_joint_sets(Source const& source) {
  std::size_t const count = source.count();
  std::vector<JointSet> sets;
  for (int set = 0; source.has(fmt::format("JOINTS_{}", set)); ++set) {
    JointSet result;
    result.weights = read_attribute<4>(source, fmt::format("WEIGHTS_{}", set));
    std::string const name = fmt::format("JOINTS_{}", set);
    std::vector<Float4> const joints = read_attribute<4>(source, name);
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
