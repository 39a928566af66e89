#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <new>

#include "core/float3.hpp"
#include "core/read_file.hpp"
#include "io/far_origin.hpp"
#include "io/faulty_geometry.hpp"
#include "io/float_colors.hpp"
#include "io/model_scene.hpp"
#include "io/names.hpp"
#include "io/ply/parts.hpp"
#include "io/points.hpp"
#include "lichtraum/ply.hpp"

namespace lichtraum {
namespace ply {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t max_findings = 100;

/// Leaves of a part what can be drawn, and counts what cannot.
GeometryFaults reduce(MeshGeometry& geometry, Drawn drawn) {
  switch (drawn) {
    case Drawn::triangles:
      return remove_faulty(geometry.indices, 3, geometry.positions);
    case Drawn::lines:
      geometry.normals = {};
      geometry.texcoords = {};
      return remove_faulty(geometry.lines, 2, geometry.positions);
    case Drawn::points:
      return {.non_finite = reduce_to_points(geometry)};
  }
  return {};
}

bool is_empty(MeshGeometry const& geometry, Drawn drawn) {
  return drawn == Drawn::triangles ? geometry.indices.empty()
         : drawn == Drawn::lines   ? geometry.lines.empty()
                                   : geometry.positions.empty();
}

/// Leaves what can be drawn, with warnings, or says that there is nothing.
void reduce(std::vector<Part>& parts, Drawn drawn, Diagnostics& diagnostics) {
  GeometryFaults faults;
  for (Part& part : parts) {
    GeometryFaults const found = reduce(part.geometry, drawn);
    faults.out_of_range += found.out_of_range;
    faults.non_finite += found.non_finite;
  }
  std::erase_if(parts, [&](Part const& part) { return is_empty(part.geometry, drawn); });
  auto const report = [&](std::size_t count, char const* what) {
    if (count == 0) return;
    std::string message = drawn == Drawn::points
                              ? fmt::format("points that are not finite are left out: {}", count)
                              : left_out_message(count, what, drawn == Drawn::lines ? "line" : "triangle");
    diagnostics.add(Severity::warning, DiagnosticCode::geometry_left_out, {}, std::move(message));
  };
  report(faults.out_of_range, "a vertex that is not there");
  report(faults.non_finite, "a vertex that is not finite");
  if (!parts.empty()) return;
  char const* const missing = drawn == Drawn::triangles ? "triangles"
                              : drawn == Drawn::lines   ? "triangles and no lines"
                                                        : "triangles and no points";
  diagnostics.add(Severity::error, DiagnosticCode::nothing_to_draw, {},
                  fmt::format("the model has nothing to draw: it has no {}", missing));
}

/// Which vertices are corners or ends; of points all are.
std::vector<bool> drawn_vertices(MeshGeometry const& geometry, Drawn drawn) {
  std::vector<bool> result(geometry.positions.size(), drawn == Drawn::points);
  for (std::uint32_t const number : drawn == Drawn::lines ? geometry.lines : geometry.indices) {
    if (number < result.size()) result[number] = true;
  }
  return result;
}

/// As far_origin of all that is drawn; `data` is what was read with no origin.
std::optional<Vec3> origin_of(Data const& data, std::string_view bytes, Header const& header) {
  std::vector<bool> const drawn = drawn_vertices(data.geometry, header.draws());
  if (std::ranges::all_of(drawn, std::identity())) return far_origin(data.extent);
  Bounds rounded;
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    Float3 const& position = data.geometry.positions[i];
    if (drawn[i] && is_finite(position)) rounded.add(to_vec3(position));
  }
  if (!may_be_far(rounded)) return std::nullopt;
  Diagnostics same({}, 0);
  return far_origin(read_data(bytes, header, same, {.drawn = &drawn}).extent);
}

void report_splats(std::size_t left_out, Diagnostics& diagnostics) {
  diagnostics.add(Severity::warning, DiagnosticCode::geometry_left_out, {},
                  fmt::format("Gaussian splats are drawn as points of one size, in their mean colours; left out, as "
                              "more than half of the light goes through them: {}",
                              left_out));
}

/// A material for each picture, called like it, and one for all parts without.
class Materials {
 public:
  explicit Materials(Scene& scene) : scene_(scene) { names_.unique("default"); }  // of what has none

  std::shared_ptr<Material const> of(Part const& part) {
    if (part.picture) return pictured(part.picture);
    if (!plain_) scene_.materials.insert(plain_ = default_material(!part.geometry.colors.empty()));
    return plain_;
  }

 private:
  std::shared_ptr<Material const> pictured(std::shared_ptr<TextureImage const> const& picture) {
    PbrModel model = matt_pbr(Rgb(1));
    model.base_color_texture.texture = std::make_shared<Texture const>(Texture{picture});
    auto material = std::make_shared<Material>(names_.unique(picture->name), std::move(model));
    scene_.materials.insert(material);
    return material;
  }

  Scene& scene_;
  std::shared_ptr<Material> plain_;
  Names names_;
};

Model import(std::string_view bytes, std::string const& name, std::optional<fs::path> const& folder,
             ModelOptions const& options) {
  Diagnostics diagnostics(name, max_findings);
  Header header;
  std::vector<Part> parts;
  std::optional<Vec3> origin;
  if (read_header(bytes, header, diagnostics)) {
    Data data = read_data(bytes, header, diagnostics, {});
    origin = origin_of(data, bytes, header);
    float const largest_color = data.largest_color, white = white_of(largest_color);
    if (origin || white != 1) {
      Diagnostics same(name, max_findings);
      data = read_data(bytes, header, same, {.origin = origin.value_or(Vec3(0)), .float_white = white});
    }
    diagnostics.begin_line({});
    if (white != 1) {
      diagnostics.add(Severity::warning, DiagnosticCode::faulty_number, {},
                      read_to_white(largest_color, "those that are floats"));
    }
    if (data.are_splats) report_splats(data.faint_splats, diagnostics);
    parts = divide(std::move(data), header, folder, options, diagnostics);
    reduce(parts, header.draws(), diagnostics);
  }
  bool const has_failed = diagnostics.errors() > 0;
  Model model;
  model.diagnostics = std::move(diagnostics).finish(0);
  check_static(options, name, header.draws() != Drawn::triangles, model.diagnostics);
  if (origin) {
    model.origin = *origin;
    model.diagnostics.push_back(moved_from(*origin, name));
  }
  if (has_failed) throw SceneError(std::move(model.diagnostics));
  Materials materials(model.scene);
  std::vector<ModelPart> named;
  for (Part& part : parts) {
    auto material = options.material ? options.material : materials.of(part);
    named.push_back({part_name(header.draws()), std::make_shared<MeshGeometry const>(std::move(part.geometry)),
                     std::move(material)});
  }
  add_parts(std::move(named), fs::path(name).stem().string(), model.scene, options.point_size);
  return model;
}

}  // namespace
}  // namespace ply

Model import_ply_bytes(std::string_view bytes, std::string const& name,
                       std::optional<std::filesystem::path> const& folder, ModelOptions const& options) {
  try {
    return ply::import(bytes, name, folder, options);
  } catch (std::bad_alloc const&) {
    throw Error(ErrorKind::scene, fmt::format("{}: the model needs more memory than there is", name));
  }
}

Model import_ply(std::filesystem::path const& path, ModelOptions const& options) {
  if (options.on_read) options.on_read(path);
  return import_ply_bytes(read_file(path), path.string(), path.parent_path(), options);
}

}  // namespace lichtraum
