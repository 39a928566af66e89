#include <fmt/format.h>

#include <new>

#include "core/read_file.hpp"
#include "io/faulty_geometry.hpp"
#include "io/image/decode.hpp"
#include "io/model_file.hpp"
#include "io/model_scene.hpp"
#include "io/ply/ply_data.hpp"
#include "io/points.hpp"
#include "lichtraum/ply.hpp"

namespace lichtraum {
namespace ply {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t max_findings = 100;

/// The picture of a "comment TextureFile", or null after a warning.
std::shared_ptr<Texture const> read_texture(std::string const& file, std::optional<fs::path> const& folder,
                                            ModelOptions const& options, Diagnostics& diagnostics) {
  std::string reason;
  auto const bytes = read_model_file(folder, options.allowed_paths, options.on_read, file, reason);
  auto image = bytes ? decode_image(*bytes, options.max_texture, reason) : std::nullopt;
  if (!image) {
    diagnostics.add(Severity::warning, DiagnosticCode::texture_left_out, {},
                    fmt::format("the picture is left out: {}", reason));
    return nullptr;
  }
  image->name = file;
  return std::make_shared<Texture const>(Texture{std::make_shared<TextureImage const>(std::move(*image))});
}

std::shared_ptr<Material> material_of(std::string const& texture_file, MeshGeometry const& geometry,
                                      std::optional<fs::path> const& folder, ModelOptions const& options,
                                      Diagnostics& diagnostics) {
  auto texture = texture_file.empty() || geometry.texcoords.empty()
                     ? nullptr
                     : read_texture(texture_file, folder, options, diagnostics);
  if (!texture) return default_material(!geometry.colors.empty());
  PbrModel model = matt_pbr(Rgb(1));
  model.base_color_texture.texture = std::move(texture);
  return std::make_shared<Material>("default", std::move(model));
}

/// Leaves what can be drawn, with warnings, or says that there is nothing.
void reduce(MeshGeometry& geometry, Drawn drawn, Diagnostics& diagnostics) {
  auto const remove = [&](std::vector<std::uint32_t>& indices, std::size_t corners, char const* noun) {
    GeometryFaults const faults = remove_faulty(indices, corners, geometry.positions);
    auto const report = [&](std::size_t count, char const* what) {
      if (count == 0) return;
      diagnostics.add(Severity::warning, DiagnosticCode::geometry_left_out, {}, left_out_message(count, what, noun));
    };
    report(faults.out_of_range, "a vertex that is not there");
    report(faults.non_finite, "a vertex that is not finite");
  };
  char const* missing = nullptr;
  if (drawn == Drawn::triangles) {
    remove(geometry.indices, 3, "triangle");
    if (geometry.indices.empty()) missing = "triangles";
  } else if (drawn == Drawn::lines) {
    geometry.normals = {};
    geometry.texcoords = {};
    remove(geometry.lines, 2, "line");
    if (geometry.lines.empty()) missing = "triangles and no lines";
  } else {
    if (std::size_t const count = reduce_to_points(geometry); count > 0) {
      diagnostics.add(Severity::warning, DiagnosticCode::geometry_left_out, {},
                      fmt::format("points that are not finite are left out: {}", count));
    }
    if (geometry.positions.empty()) missing = "triangles and no points";
  }
  if (missing) {
    diagnostics.add(Severity::error, DiagnosticCode::nothing_to_draw, {},
                    fmt::format("the model has nothing to draw: it has no {}", missing));
  }
}

char const* part_name(Drawn drawn) {
  switch (drawn) {
    case Drawn::triangles:
      return "mesh";
    case Drawn::lines:
      return "lines";
    case Drawn::points:
      return "points";
  }
  return "";
}

Model import(std::string_view bytes, std::string const& name, std::optional<fs::path> const& folder,
             ModelOptions const& options) {
  Diagnostics diagnostics(name, max_findings);
  Header header;
  auto geometry = std::make_shared<MeshGeometry>();
  if (read_header(bytes, header, diagnostics)) {
    *geometry = read_data(bytes, header, diagnostics);
    diagnostics.begin_line({});
    reduce(*geometry, header.draws(), diagnostics);
  }
  bool const has_failed = diagnostics.errors() > 0;
  Model model;
  std::shared_ptr<Material const> material = options.material;
  if (!has_failed && !material) {
    auto const own = material_of(header.texture_file, *geometry, folder, options, diagnostics);
    // Programs that make both from photographs write the same in either: they would darken each other.
    if (own->pbr() && own->pbr()->base_color_texture) geometry->colors = {};
    model.scene.materials.insert(own);
    material = own;
  }
  model.diagnostics = std::move(diagnostics).finish(0);
  check_static(options, name, header.draws() != Drawn::triangles, model.diagnostics);
  if (has_failed) throw SceneError(std::move(model.diagnostics));
  add_parts({{part_name(header.draws()), std::move(geometry), std::move(material)}}, fs::path(name).stem().string(),
            model.scene, options.point_size);
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
