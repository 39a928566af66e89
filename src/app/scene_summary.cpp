#include "app/scene_summary.hpp"

#include <algorithm>
#include <unordered_set>

namespace lichtraum::app {
namespace {

std::vector<TextureImage const*> textures_of(Scene const& scene) {
  std::vector<TextureImage const*> images;
  std::unordered_set<TextureImage const*> known;
  for (auto const& material : scene.materials) {
    if (!material->pbr()) continue;
    for (auto const slot : texture_slots) {
      auto const& texture = (material->pbr()->*slot).texture;
      if (texture && texture->image && known.insert(texture->image.get()).second)
        images.push_back(texture->image.get());
    }
  }
  return images;
}

}  // namespace

SceneSummary summarise(Scene const& scene, Job job) {
  GraphSummary const drawn = lichtraum::summarise(scene.roots());
  SceneSummary summary;
  summary.defined = lichtraum::summarise({scene.shapes.begin(), scene.shapes.end()}).defined;
  summary.drawn = drawn.drawn;
  summary.bounds = drawn.bounds;
  summary.textures = textures_of(scene);
  summary.scene = &scene;
  summary.background = scene.background;
  if (is_model_file(job.scene)) {
    if (auto const usual = resolved(job, scene).background) summary.background = usual->shown.value_or(Rgb(0));
  }
  std::size_t const pictures = std::max<std::size_t>(1, scene.renders.size());
  for (job.picture = 0; std::size_t(job.picture) < pictures; ++job.picture) {
    summary.integrators.push_back(chosen_integrator(job, scene));
  }
  return summary;
}

}  // namespace lichtraum::app
