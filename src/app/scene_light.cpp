#include "app/scene_light.hpp"

#include <algorithm>
#include <variant>

#include "lichtraum/graph_summary.hpp"

namespace lichtraum::app {
namespace {

struct BrightnessVisitor : LightFieldVisitor {
  bool is_on = false;
  void brightness(char const*, Rgb const& color) { is_on |= color != Rgb(0); }
  void ambient(char const*, Rgb const& color) { is_on |= color != Rgb(0); }
};

bool is_on(Light const& light) {
  BrightnessVisitor visitor;
  std::visit([&](auto const& model) { for_each_field(model, visitor); }, light.model());
  return visitor.is_on;
}

bool shines(std::shared_ptr<Material const> const& material) {
  PbrModel const* const pbr = material->pbr();
  return pbr ? pbr->unlit || pbr->emissive != Rgb(0) : material->phong().emission != Rgb(0);
}

}  // namespace

SceneLight light_in(Scene const& scene, Integrator integrator) {
  bool const has_environment = scene.environment && scene.environment->brightness > 0;
  bool const shows_environment = integrator == Integrator::path;
  if (has_environment && shows_environment) return SceneLight::some;
  if (std::any_of(scene.lights.begin(), scene.lights.end(), is_on)) return SceneLight::some;
  if (std::ranges::any_of(materials_of(scene.roots()), shines)) return SceneLight::some;
  if (has_environment) return SceneLight::unused;
  return scene.environment && shows_environment ? SceneLight::dimmed : SceneLight::none;
}

}  // namespace lichtraum::app
