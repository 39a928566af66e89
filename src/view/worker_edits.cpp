#include <memory>
#include <utility>

#include "view/worker.hpp"

// How a Worker draws a scene with other lights and materials.

namespace lichtraum::view {
namespace {

/// Of the scene with edits, all that decides what draws it; no shapes, which may be many.
Scene lighting_of(Scene const& scene, SceneEdits const& edits) {
  Scene lighting;
  lighting.renders = scene.renders;
  lighting.environment = scene.environment;
  for (Light const& light : scene.lights) lighting.lights.insert(light);
  for (auto const& material : scene.materials) {
    auto const edited = edits.materials.find(material.get());
    lighting.materials.insert(edited == edits.materials.end() ? material : std::make_shared<Material>(edited->second));
  }
  return lighting;
}

}  // namespace

unsigned Worker::edit(unsigned number, SceneEdits edits) {
  std::lock_guard const lock(mutex_);
  edits_ = {number, std::move(edits)};
  return begin_view();
}

void Worker::apply_edits(Renderer& renderer) {
  std::optional<SceneEdits> edits = take(edits_);
  if (!edits) return;
  try {
    renderer.set_scene(renderer.edit(prepared_, *edits));
    edits_in_place_ = std::move(*edits);
    has_edits_ = true;
    film_ = {};
    choose_integrator_again();
  } catch (std::exception const& error) {  // as for want of memory, on the device or off it
    tell_of(error);
    wake_();
  }
}

void Worker::choose_integrator_again() {
  Scene const& scene = loaded_->scene();
  Integrator const integrator =
      chosen_integrator(reading_.job, lighting_of(scene, edits_in_place_), load_options_.device).integrator;
  if (loaded_job_.integrator == integrator) return;
  loaded_job_.integrator = integrator;
  denoising_ = decided(loaded_job_.denoising, integrator);
  EditedView edited{scene_number_, view_of(loaded_job_, scene)};
  {
    std::lock_guard const lock(mutex_);
    news_.edited = std::move(edited);
    seconds_per_pixel_.reset();
  }
  wake_();
}

}  // namespace lichtraum::view
