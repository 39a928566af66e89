#include "io/model_scene.hpp"

#include "io/framing.hpp"
#include "io/names.hpp"
#include "scene/graph_fold.hpp"

namespace lichtraum {

void add_parts(std::vector<ModelPart> parts, std::string const& name, Scene& scene) {
  Names names;
  std::string const root_name = names.unique(name.empty() ? "model" : name);
  Composite::Children children;
  for (ModelPart& part : parts) {
    auto mesh = std::make_shared<Mesh>(names.unique(part.name), std::move(part.geometry), std::move(part.material));
    scene.shapes.insert(mesh);
    children.push_back(std::move(mesh));
  }
  scene.shapes.insert(std::make_shared<Composite>(root_name, std::move(children)));
  Bounds const box = fold_bounds(scene.roots()).total();
  scene.cameras.insert(frame_box("default", box));
  for (Light& light : studio_lights(box)) scene.lights.insert(std::move(light));
}

PbrMaterial matt_pbr(Rgb const& color) {
  PbrMaterial pbr;
  pbr.base_color = glm::dvec4(color, 1);
  pbr.metallic = 0;
  pbr.specular = 0;
  return pbr;
}

std::shared_ptr<Material> default_material(bool has_colors) {
  Rgb const color(has_colors ? 1 : 0.8);
  auto material = std::make_shared<Material>("default", color, color, Rgb(0), 1);
  material->set_pbr(std::make_shared<PbrMaterial const>(matt_pbr(color)));
  return material;
}

void check_static(ModelOptions const& options, std::string const& file, std::vector<Diagnostic>& diagnostics) {
  auto const warn = [&](char const* message) {
    diagnostics.push_back({Severity::warning, {file, 0, 0}, 1, message, {}, {}});
  };
  if (options.time_seconds || !options.animation.empty()) warn("it has no animation; the time has no effect");
  if (!options.scene.empty()) warn("it has one scene only; asking for another has no effect");
}

}  // namespace lichtraum
