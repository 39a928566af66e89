#include "app/quick_look.hpp"

#include <algorithm>
#include <cmath>

#include "app/renderer_choice.hpp"
#include "app/scene_source.hpp"
#include "lichtraum/denoise.hpp"

namespace lichtraum::app {
namespace {

/// Enough for a small picture.
Sampling usual_sampling(RenderRequest const& view) {
  if (view.camera.lens().aperture > 0) return {Sampling::Pattern::seeded, 64};
  if (view.integrator == Integrator::path) return {Sampling::Pattern::seeded, 16};
  return {Sampling::Pattern::grid, 9};
}

}  // namespace

QuickLook::QuickLook(RenderOptions const& options, Console const& console) {
  SceneSource const source(options.scenes.front(), options.input_format);
  renderer_ = choose_renderer(options.device, std::nullopt, console);
  Job job = source.job(options.job);
  LoadOptions load;
  load.set_drawing(job, renderer_->device().kind);
  load.has_size = true;  // its pictures are made to fit somewhere; only their proportions are the scene's
  LoadedScene loaded = source.load(job.reading, load);
  console.show(loaded.diagnostics());
  bool const has_sampling = job.sampling.has_value();
  job.integrator = chosen_integrator(job, loaded.scene(), load.device).integrator;
  job = resolved(std::move(job), loaded.scene());
  loaded.play([&](Scene const& scene, std::size_t) {
    request_ = view_of(job, scene);
    if (!has_sampling) request_.sampling = usual_sampling(request_);
    development_ = development_of(job, scene);
    renderer_->set_scene(scene, job.root);
    return false;
  });
}

Image QuickLook::draw(Resolution const& size) const {
  RenderRequest request = request_;
  request.resolution = size;
  request.region = whole_picture(size);
  bool const is_noisy = request.integrator == Integrator::path;
  if (is_noisy) request.planes = with_guides(request.planes);
  Film film;
  renderer_->render(request, film);
  if (is_noisy) {
    Denoiser denoiser([&](NoisyPicture const& picture) { return renderer_->filter_noise(picture); });
    film = denoiser.denoised(film, Denoising::builtin);
  }
  return renderer_->develop(std::move(film), development_);
}

Resolution fitted(Resolution const& picture, double width, double height) {
  double const scale = std::min(width / picture.width, height / picture.height);
  return {std::max(1, int(std::lround(picture.width * scale))), std::max(1, int(std::lround(picture.height * scale)))};
}

}  // namespace lichtraum::app
