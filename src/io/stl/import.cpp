#include <fmt/format.h>

#include <new>

#include "core/ascii.hpp"
#include "core/read_file.hpp"
#include "io/another_file.hpp"
#include "io/far_origin.hpp"
#include "io/model_scene.hpp"
#include "io/stl/facets.hpp"
#include "lichtraum/stl.hpp"

namespace lichtraum {
namespace stl {
namespace {

constexpr std::size_t max_findings = 100;

Model import(std::string_view bytes, std::string const& name, ModelOptions const& options) {
  Diagnostics diagnostics(name, max_findings);
  if (!is_stl(bytes) && is_another_file(bytes, "an STL file", DiagnosticCode::not_stl, diagnostics)) {
    throw SceneError(std::move(diagnostics).finish(0));
  }
  auto const read = is_binary(bytes) ? read_binary : read_ascii;
  Solids file = read(bytes, diagnostics, Vec3(0));
  auto const origin = far_origin(file.extent);
  if (origin) {
    Diagnostics same(name, max_findings);
    file = read(bytes, same, *origin);
  }
  Model model;
  model.scene.up = {0, 0, 1};  // as programs for printers and machine tools have it
  std::shared_ptr<Material const> material = options.material;
  if (!material) {
    auto const own = default_material(false);
    model.scene.materials.insert(own);
    material = own;
  }
  std::vector<ModelPart> parts;
  for (Solid& solid : file.solids) {
    if (solid.corners.empty()) continue;
    std::string part = solid.name.empty() ? "mesh" : std::move(solid.name);
    parts.push_back({std::move(part), merged(std::move(solid.corners)), material});
  }
  bool const has_failed = parts.empty();
  if (has_failed && diagnostics.errors() == 0) {
    diagnostics.begin_line({});
    diagnostics.add(Severity::error, DiagnosticCode::nothing_to_draw, {},
                    "the model has nothing to draw: it has no triangles");
  }
  model.diagnostics = std::move(diagnostics).finish(0);
  check_static(options, name, false, model.diagnostics);
  if (origin) {
    model.origin = *origin;
    model.diagnostics.push_back(moved_from(*origin, name));
  }
  if (has_failed) throw SceneError(std::move(model.diagnostics));
  add_parts(std::move(parts), std::filesystem::path(name).stem().string(), model.scene);
  return model;
}

}  // namespace
}  // namespace stl

bool is_stl(std::string_view bytes) {
  Line line;
  LineReader lines(bytes);
  Token word;
  while (word.empty() && lines.next(line)) {
    std::string_view rest = line.text;
    word = next_token(rest);
  }
  return to_lower_ascii(word) == "solid" || stl::has_binary_size(bytes);
}

Model import_stl_bytes(std::string_view bytes, std::string const& name, ModelOptions const& options) {
  try {
    return stl::import(bytes, name, options);
  } catch (std::bad_alloc const&) {
    throw Error(ErrorKind::scene, fmt::format("{}: the model needs more memory than there is", name));
  }
}

Model import_stl(std::filesystem::path const& path, ModelOptions const& options) {
  if (options.on_read) options.on_read(path);
  return import_stl_bytes(read_file(path), path.string(), options);
}

}  // namespace lichtraum
