#include "view/scene_values.hpp"

#include <algorithm>
#include <unordered_set>

namespace lichtraum::view {

SceneValues::SceneValues(Scene const& scene, DrawnObjects const& objects)
    : lights(scene.lights.begin(), scene.lights.end()),
      environment(scene.environment),
      original_lights_(lights),
      original_environment_(environment) {
  std::unordered_set<Shape const*> seen;
  std::vector<Shape const*> pending;
  for (auto const& root : objects.roots()) pending.push_back(root.get());
  while (!pending.empty()) {
    Shape const* const shape = pending.back();
    pending.pop_back();
    if (auto const* const composite = dynamic_cast<Composite const*>(shape)) {
      if (!seen.insert(shape).second) continue;
      for (auto const& child : composite->children()) pending.push_back(child.get());
    } else if (shape->material() && places_.emplace(shape->material().get(), 0).second) {
      auto const* const listed = scene.materials.find(shape->material()->name());
      materials.push_back({shape->material().get(), *shape->material(), listed && *listed == shape->material()});
    }
  }
  std::sort(materials.begin(), materials.end(),
            [](auto const& a, auto const& b) { return a.value.name() < b.value.name(); });
  for (std::size_t i = 0; i < materials.size(); ++i) places_[materials[i].original] = i;
}

bool SceneValues::is_environment_edited() const {
  return environment && original_environment_ &&
         (environment->rotation_degrees != original_environment_->rotation_degrees ||
          environment->brightness != original_environment_->brightness);
}

bool SceneValues::is_edited() const {
  return lights != original_lights_ || is_environment_edited() ||
         std::any_of(materials.begin(), materials.end(), [](auto const& material) { return material.is_edited; });
}

void SceneValues::reset() {
  lights = original_lights_;
  environment = original_environment_;
  for (std::size_t i = 0; i < materials.size(); ++i) reset_material(i);
}

SceneEdits SceneValues::edits() const {
  SceneEdits edits;
  if (lights != original_lights_) edits.lights = lights;
  edits.environment = environment;
  for (EditableMaterial const& material : materials) {
    if (material.is_edited) edits.materials.emplace(material.original, material.value);
  }
  return edits;
}

std::size_t const* SceneValues::find(Material const* original) const {
  auto const found = places_.find(original);
  return found == places_.end() ? nullptr : &found->second;
}

}  // namespace lichtraum::view
