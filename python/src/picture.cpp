#include "picture.hpp"

#include <fmt/format.h>

#include "app/picture_faults.hpp"
#include "app/picture_plan.hpp"
#include "app/traced_picture.hpp"

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

void warn(Picture& picture, DiagnosticCode code, std::string message) {
  if (message.empty()) return;
  picture.diagnostics.push_back({Severity::warning, code, {}, 1, std::move(message), {}, {}});
}

void trace(Renderer& renderer, Picture& picture, ProgressFunction const& progress) {
  auto const limit = picture.job.noise;
  auto const [result, noise] = app::trace_picture(renderer, picture.request, limit, picture.film, progress);
  picture.is_complete = result.complete;
  picture.statistics = result.statistics;
  if (std::string const left = app::noise_left(picture.film, limit, noise); picture.is_complete && !left.empty())
    warn(picture, DiagnosticCode::noise_left, left + ": more samples");
  warn(picture, DiagnosticCode::samples_left_out, app::samples_left_out(picture.statistics));
}

/// What it fails to show.
void warn_of_faults(Picture& picture, Scene const& scene, Bounds const& bounds, bool is_model) {
  app::Sight sight;
  sight.add(picture.statistics.rays, picture.film);
  if (picture.film.planes().has(FilmPlane::radiance)) sight.add(picture.developed, picture.development);
  Background const background = picture.request.background.value_or(scene.background);
  app::DrawnPicture const drawn{picture.request,
                                picture.development,
                                background,
                                bounds,
                                app::light_in(scene, picture.request.integrator),
                                is_model,
                                picture.request.region == whole_picture(picture.request.resolution),
                                scene.environment ? std::string_view(scene.environment->map->repairs) : ""};
  for (auto& [fault, finding] : app::faults_of(drawn, sight)) picture.diagnostics.push_back(std::move(finding));
}

/// With the noise taken out, if that is asked for.
Film quiet(Renderer& renderer, Picture& picture) {
  Denoising const denoising = picture.job.denoising;
  if (denoising == Denoising::off) return picture.film;
  Denoiser denoiser([&renderer](NoisyPicture const& noisy) { return renderer.filter_noise(noisy); });
  Film film = app::without_noise(denoiser, picture.film, denoising, picture.request);
  picture.denoiser = denoiser.name(denoising);
  warn(picture, DiagnosticCode::other_denoiser, denoiser.take_note());
  return film;
}

}  // namespace

Picture draw(Renderer& renderer, Scene const& scene, bool is_model, Job job,
             std::shared_ptr<PreparedScene const>& previous, Control& control) {
  Picture picture;
  picture.device = renderer.device();
  picture.job = decided(std::move(job), scene, renderer.device().kind);
  auto const prepared = renderer.prepare(scene, picture.job.root, previous);
  previous = prepared;
  picture.request = request_of(picture.job, scene);
  picture.development = development_of(picture.job, scene);
  picture.scene.fingerprint = prepared->fingerprint;
  renderer.set_scene(prepared);
  if (control.stops()) picture.is_complete = false;
  if (picture.is_complete) trace(renderer, picture, control.progress());
  if (!picture.is_complete) return picture;
  Film film = quiet(renderer, picture);
  if (film.planes().has(FilmPlane::radiance)) picture.radiance = film.values(FilmPlane::radiance);
  picture.developed = app::shown_picture(renderer, std::move(film), picture.development);
  warn_of_faults(picture, scene, prepared->bounds, is_model);
  picture.film.keep(shown_planes(picture.job));
  for (FilmPlane const plane : picture.film.planes().list()) {
    if (!info_of(plane).is_number) picture.planes[plane] = picture.film.values(plane);
  }
  return picture;
}

void Picture::check_format(ImageFormat const& format, ValueEncoding const& encoding, std::string const& shown) const {
  Job stored = job;
  stored.encoding = encoding;
  app::Output output;
  output.format = &format;
  output.shown = shown;
  app::check_format(stored, output);
}

std::string Picture::encoded(ImageFormat const& format, ValueEncoding const& encoding) const {
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
