#include "io/model_scene.hpp"

#include "io/framing.hpp"
#include "io/names.hpp"
#include "io/points.hpp"
#include "lichtraum/orbit.hpp"
#include "scene/graph_fold.hpp"

namespace lichtraum {

void add_parts(std::vector<ModelPart> parts, std::string const& name, Scene& scene, std::optional<double> point_size) {
  Names names;
  std::string const root_name = names.unique(name.empty() ? "model" : name);
  Composite::Children children;
  for (ModelPart& part : parts) {
    auto shape = make_shape(names.unique(part.name), std::move(part.geometry), std::move(part.material));
    scene.shapes.insert(shape);
    children.push_back(std::move(shape));
  }
  scene.shapes.insert(std::make_shared<Composite>(root_name, std::move(children)));
  set_point_sizes(scene, point_size);
  Bounds const box = fold_bounds(scene.roots()).total();
  scene.cameras.insert(frame_box("default", box, scene.up));
  scene.has_own_lights = false;
  scene.has_own_cameras = false;
  for (Light& light : studio_lights(box, three_quarter_view.azimuth_degrees, scene.up))
    scene.lights.insert(std::move(light));
}

PbrModel matt_pbr(Rgb const& color) {
  return {.base_color = color, .metallic = 0, .specular = 0, .double_sided = true};
}

std::shared_ptr<Material> default_material(bool has_colors) {
  if (has_colors) return std::make_shared<Material>("default", matt_pbr(Rgb(1)));
  return std::make_shared<Material>("default", PhongModel{.ka = default_grey, .kd = default_grey});
}

void check_static(ModelOptions const& options, std::string const& file, bool has_points_or_lines,
                  std::vector<Diagnostic>& diagnostics) {
  auto const warn = [&](char const* message) {
    diagnostics.push_back({Severity::warning, DiagnosticCode::option_without_effect, {file, 0, 0}, 1, message, {}, {}});
  };
  if (options.time_seconds || !options.animation.empty()) warn("it has no animation; the time has no effect");
  if (!options.scene.empty()) warn("it has one scene only; asking for another has no effect");
  if (!options.variant.empty()) warn("its materials have no variants; asking for one has no effect");
  if (options.point_size && !has_points_or_lines) warn(no_points_to_size);
}

}  // namespace lichtraum
