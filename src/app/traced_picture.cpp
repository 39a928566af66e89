#include "app/traced_picture.hpp"

#include <fmt/format.h>

#include <utility>

namespace lichtraum::app {

NoiseLimitedResult trace_picture(Renderer& renderer, RenderRequest const& request, std::optional<double> noise_limit,
                                 Film& film, ProgressFunction const& progress) {
  if (noise_limit) return render_to_noise(renderer, request, *noise_limit, film, progress);
  return {renderer.render(request, film, progress), {}};
}

Film without_noise(Denoiser& denoiser, Film const& film, Denoising denoising, RenderRequest const& request) {
  // A lens blurs albedo and normals, too.
  return denoiser.denoised(film, denoising, {request.camera.lens().aperture > 0, has_shadows_in_alpha(request)});
}

Image shown_picture(Renderer& renderer, Film film, Development const& development) {
  if (film.planes().has(FilmPlane::radiance)) return renderer.develop(std::move(film), development);
  return show_plane(film, film.planes().list().front(), development.transfer);
}

std::string noise_left(Film const& film, std::optional<double> limit, std::optional<double> noise) {
  if (!limit || !noise || *noise <= *limit) return {};
  return fmt::format("after {} samples the noise is {:.2g}, not {}", film.samples().count(), *noise, *limit);
}

std::string samples_left_out(RenderStatistics const& statistics) {
  auto const count = statistics.rays.not_finite;
  if (count == 0) return {};
  return fmt::format("{} samples are left out: their radiance is not a finite number", count);
}

}  // namespace lichtraum::app
