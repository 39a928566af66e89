#include "picture.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/picture_plan.hpp"
#include "lichtraum/noise_limit.hpp"

namespace lichtraum::python {
namespace {

Job decided(Job job, Scene const& scene, DeviceKind device) {
  job.integrator = chosen_integrator(job, scene, device).integrator;
  bool const is_size_asked = job.size.has_value();
  job = resolved(std::move(job), scene);
  if (!job.planes.has(FilmPlane::radiance)) job.denoising = Denoising::off;  // other planes have no noise
  app::check_memory(*job.region, traced_planes(job), job.sampling->count,
                    is_size_asked ? ErrorKind::usage : ErrorKind::scene, job.denoising != Denoising::off);
  return job;
}

Diagnostic warning(DiagnosticCode code, std::string message) {
  return {Severity::warning, code, {}, 1, std::move(message), {}, {}};
}

void trace(Renderer& renderer, Picture& picture, ProgressFunction const& progress) {
  if (auto const limit = picture.job.noise) {
    auto const limited = render_to_noise(renderer, picture.request, *limit, picture.film, progress);
    picture.is_complete = limited.render.complete;
    picture.statistics = limited.render.statistics;
    if (picture.is_complete && limited.noise && *limited.noise > *limit) {
      picture.diagnostics.push_back(
          warning(DiagnosticCode::noise_left, fmt::format("after {} samples the noise is {:.2g}, not {}: more samples",
                                                          picture.film.samples().count(), *limited.noise, *limit)));
    }
  } else {
    RenderResult const result = renderer.render(picture.request, picture.film, progress);
    picture.is_complete = result.complete;
    picture.statistics = result.statistics;
  }
  if (auto const count = picture.statistics.rays.not_finite; count > 0) {
    picture.diagnostics.push_back(
        warning(DiagnosticCode::samples_left_out,
                fmt::format("{} samples are left out: their radiance is not a finite number", count)));
  }
}

/// With the noise taken out, if that is asked for.
Film quiet(Renderer& renderer, Picture& picture) {
  Denoising const denoising = picture.job.denoising;
  if (denoising == Denoising::off) return picture.film;
  Denoiser denoiser([&renderer](NoisyPicture const& noisy) { return renderer.filter_noise(noisy); });
  NoiseBesides const besides{picture.request.camera.lens().aperture > 0, has_shadows_in_alpha(picture.request)};
  Film film = denoiser.denoised(picture.film, denoising, besides);
  picture.denoiser = denoiser.name(denoising);
  if (std::string note = denoiser.take_note(); !note.empty())
    picture.diagnostics.push_back(warning(DiagnosticCode::other_denoiser, std::move(note)));
  return film;
}

}  // namespace

Picture draw(Renderer& renderer, Scene const& scene, Job job, std::shared_ptr<PreparedScene const>& previous,
             ProgressFunction const& progress) {
  Picture picture;
  picture.device = renderer.device();
  picture.job = decided(std::move(job), scene, renderer.device().kind);
  auto const prepared = renderer.prepare(scene, picture.job.root, previous);
  previous = prepared;
  picture.request = request_of(picture.job, scene);
  picture.development = development_of(picture.job, scene);
  picture.scene.fingerprint = prepared->fingerprint;
  renderer.set_scene(prepared);
  trace(renderer, picture, progress);
  if (!picture.is_complete) return picture;
  if (picture.job.planes.has(FilmPlane::radiance)) {
    Film film = quiet(renderer, picture);
    picture.radiance = film.values(FilmPlane::radiance);
    picture.developed = renderer.develop(std::move(film), picture.development);
  } else {
    picture.developed = show_plane(picture.film, picture.job.planes.list().front());
  }
  picture.film.keep(shown_planes(picture.job));
  for (FilmPlane const plane : picture.film.planes().list()) {
    if (!info_of(plane).is_number) picture.planes[plane] = picture.film.values(plane);
  }
  return picture;
}

std::string Picture::encoded(ImageFormat const& format, ValueEncoding const& encoding) const {
  if (encoding.bits > format.max_bits) {
    throw Error(ErrorKind::usage, fmt::format("bits={}: a {} has {} bits per channel; png and ppm have 16",
                                              encoding.bits, format.name, format.max_bits));
  }
  if (std::max(request.region.width, request.region.height) > format.max_side) {
    throw Error(ErrorKind::usage, fmt::format("a {} has at most {} pixels per side, not {}x{}", format.name,
                                              format.max_side, request.region.width, request.region.height));
  }
  bool const is_transparent = request.planes.has(FilmPlane::alpha) && !developed.alpha().empty();
  if (format.encode && is_transparent && !format.has_alpha) {
    throw Error(ErrorKind::usage, fmt::format("a {} cannot be transparent: png and exr pictures can", format.name));
  }
  Job stored = job;
  if (format.encode_film) stored.denoising = Denoising::off;  // planes are stored as they were traced
  RenderRequest traced = request;
  traced.planes = traced_planes(stored);
  std::string fingerprint = picture_fingerprint(scene, traced, format.encode ? development : Development()) +
                            fmt::format("-{}", encoding.bits);
  if (job.noise) fingerprint += fmt::format("-noise-{}", *job.noise);
  if (stored.denoising != Denoising::off) fingerprint += "-" + denoiser;
  ImageEncoding const how{encoding, fingerprint};
  return format.encode_film ? format.encode_film(film, how) : format.encode(developed, how);
}

}  // namespace lichtraum::python
