#include "app/scene_summary.hpp"

#include <algorithm>
#include <unordered_set>

namespace lichtraum::app {
namespace {

/// Those that the scene lists, and those of models in it, which only their shapes have.
std::vector<std::shared_ptr<Material const>> all_materials(Scene const& scene) {
  std::vector<std::shared_ptr<Material const>> materials(scene.materials.begin(), scene.materials.end());
  std::unordered_set<std::shared_ptr<Material const>> known(materials.begin(), materials.end());
  for (auto const& material : materials_of({scene.shapes.begin(), scene.shapes.end()})) {
    if (known.insert(material).second) materials.push_back(material);
  }
  return materials;
}

std::vector<TextureImage const*> textures_of(std::vector<std::shared_ptr<Material const>> const& materials) {
  std::vector<TextureImage const*> images;
  std::unordered_set<TextureImage const*> known;
  for (auto const& material : materials) {
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
  auto const materials = all_materials(scene);
  summary.material_count = materials.size();
  summary.textures = textures_of(materials);
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
