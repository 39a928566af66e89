#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>

#include "film/check_request.hpp"
#include "job/viewpoint.hpp"
#include "lichtraum/error.hpp"
#include "lichtraum/graph_summary.hpp"
#include "lichtraum/job.hpp"
#include "lichtraum/turntable.hpp"

namespace lichtraum {
namespace {

constexpr Resolution default_size{640, 480};

bool is_model(Job const& job) { return !job.text && is_model_file(job.scene); }

/// Whether an environment is something to look at: the built-in one is lamps.
bool is_view(std::string const& source) { return !source.empty() && source != "studio" && source != "none"; }

/// Of pictures by paths: a map that was asked for, or the scene's own unless it has a background besides; before models
/// a quiet grey, from above.
std::optional<JobBackground> usual_background(Job const& job, Scene const& scene) {
  std::string const& asked = job.reading.environment.source;
  bool const is_own = asked.empty() && scene.environment && scene.background == Rgb(0);
  if (is_view(is_own ? scene.environment->source : asked)) return JobBackground{Background::environment()};
  if (is_model(job)) return JobBackground{Background(Rgb(0.45), Rgb(0.18))};
  return {};
}

/// Whether all that is drawn shows its own colour, which a curve would change.
bool is_unlit(Scene const& scene) {
  auto const materials = materials_of(scene.roots());
  return !materials.empty() && std::ranges::all_of(materials, [](auto const& material) {
    PbrModel const* const pbr = material->pbr();
    return pbr && pbr->unlit;
  });
}

/// Whether a scene file is drawn in an environment that its author has not reckoned with: most of the picture would be
/// white without a curve, and the light is that of photographs, not of numbers made for files without gamma.
bool is_relit(Job const& job, Scene const& scene) {
  std::string const& asked = job.reading.environment.source;
  return !is_model(job) && !asked.empty() && asked != "none" && scene.tone_map == ToneMap::none &&
         chosen_integrator(job, scene).integrator == Integrator::path;
}

ToneMap usual_tone_map(Job const& job, Scene const& scene) {
  if (is_relit(job, scene)) return ToneMap::neutral;
  if (!is_model(job) || chosen_integrator(job, scene).integrator != Integrator::path) return scene.tone_map;
  return is_unlit(scene) ? ToneMap::none : ToneMap::neutral;
}

Transfer usual_transfer(Job const& job, Scene const& scene) {
  return is_model(job) || is_relit(job, scene) ? Transfer::srgb : Transfer::linear;
}

/// What an integrator draws with unless asked otherwise.
struct Effort {
  int samples;
  int max_depth;
};
Effort usual_effort(Integrator integrator, bool is_model, bool has_lens) {
  switch (integrator) {
    case Integrator::whitted:
      return {has_lens ? 64 : 1, 5};
    case Integrator::path:
      return {is_model ? 16 : 64, 64};  // chance ends most paths before
  }
  return {};
}

/// What the scene says about the job's picture.
RenderCommand command_of(Job const& job, Scene const& scene) {
  std::size_t const count = std::max<std::size_t>(1, scene.renders.size());
  if (job.picture < 0 || std::size_t(job.picture) >= count) {
    throw Error(ErrorKind::usage, fmt::format("{}: there is no picture {}: the scene has {}, counted from 0", job.scene,
                                              job.picture, count));
  }
  return scene.renders.empty() ? RenderCommand() : scene.renders[std::size_t(job.picture)];
}

/// With their numbers, by which they may be chosen.
std::string list_cameras(Scene const& scene) {
  std::string list;
  int number = 0;
  for (Camera const& camera : scene.cameras) {
    list += fmt::format("{}{} {}", list.empty() ? "" : ", ", number++, camera.name());
  }
  return list;
}

/// Where none is defined, any will do that the job moves.
Camera find_camera(Job const& job, Scene const& scene, std::string const& name_in_scene) {
  if (scene.cameras.empty() && has_place(job.view)) return {};
  if (scene.cameras.empty()) {
    throw Error(ErrorKind::scene,
                fmt::format("{}: there is no camera, so nothing can be drawn; 'define camera eye 45' "
                            "puts one at the origin that looks along -z, and --orbit 35,20 needs none",
                            job.scene));
  }
  std::string const& name = job.camera.empty() ? name_in_scene : job.camera;
  if (name.empty()) return scene.cameras.front();
  if (Camera const* const camera = scene.cameras.find(name)) return *camera;
  std::size_t number = 0;
  auto const [end, error] = std::from_chars(name.data(), name.data() + name.size(), number);
  bool const is_number = error == std::errc() && end == name.data() + name.size();
  if (!job.camera.empty() && is_number && number < scene.cameras.size()) {
    return *std::next(scene.cameras.begin(), std::ptrdiff_t(number));
  }
  throw Error(job.camera.empty() ? ErrorKind::scene : ErrorKind::usage,
              fmt::format("{}: there is no camera '{}'; there are: {}", job.scene, name, list_cameras(scene)));
}

/// In a grid, one sample is the middle of its pixel.
Sampling sampling_of(int count) { return {count == 1 ? Sampling::Pattern::grid : Sampling::Pattern::seeded, count}; }

/// Of a job that is decided.
RenderRequest request_through(Camera const& camera, Job const& job) {
  RenderRequest request;
  request.camera = camera;
  request.resolution = *job.size;
  request.region = *job.region;
  request.integrator = *job.integrator;
  request.sampling = *job.sampling;
  request.samples = job.samples;
  request.max_depth = *job.max_depth;
  if (job.max_indirect) request.max_indirect = *job.max_indirect;
  request.seed = job.seed;
  request.planes = traced_planes(job);
  if (job.background) request.background = job.background->shown;
  request.ground = job.ground;
  return request;
}

/// Whether a surface of the scene itself, not of a model in it, lights others.
bool has_shining_material(Scene const& scene) {
  return std::any_of(scene.materials.begin(), scene.materials.end(), [](auto const& material) {
    auto const* const phong = std::get_if<PhongModel>(&material->model());
    return phong && phong->emission != Rgb(0);
  });
}

bool has_lamp_with_size(Scene const& scene) {
  return std::any_of(scene.lights.begin(), scene.lights.end(), [](Light const& light) {
    auto const* const lamp = light.get<PointLight>();
    return lamp && lamp->radius > 0;
  });
}

/// Those that are no part of the request, nor of the view; the same as in JSON.
void check_numbers(Job const& job) {
  auto const require = [](bool holds, std::string const& message) {
    if (!holds) throw Error(ErrorKind::usage, message);
  };
  require(!job.noise || (*job.noise > 0 && *job.noise <= 1), "--noise: expected a number above 0, at most 1");
  constexpr double most = job_limits::exposure_ev;
  require(std::abs(job.exposure_ev) <= most, fmt::format("--exposure: expected stops from {} to {}", -most, most));
  require(!job.turn_degrees || std::isfinite(*job.turn_degrees), "turn_degrees: expected a number that is finite");
}

}  // namespace

Integrator usual_integrator(bool is_model, DeviceKind device) {
  return is_model && device != DeviceKind::reference ? Integrator::path : Integrator::whitted;
}

std::optional<Integrator> asked_integrator(Job const& job) {
  if (job.integrator || job.ground == Ground::none) return job.integrator;
  return Integrator::path;
}

IntegratorChoice chosen_integrator(Job const& job, Scene const& scene, DeviceKind device) {
  if (job.integrator) return {*job.integrator, "that is asked for"};
  if (auto const asked = command_of(job, scene).integrator) return {*asked, "the scene's render asks for it"};
  if (job.ground != Ground::none) return {Integrator::path, "only paths show a ground"};
  if (is_model(job)) {
    bool const is_reference = device == DeviceKind::reference;
    return {usual_integrator(true, device),
            is_reference ? "the reference tracer follows paths too slowly" : "that is the default for models"};
  }
  if (scene.environment) return {Integrator::path, "only paths show an environment's light"};
  if (has_lamp_with_size(scene)) return {Integrator::path, "only paths show a lamp's size"};
  if (has_shining_material(scene)) return {Integrator::path, "only paths show what an emission lights"};
  return {usual_integrator(false, device), "that is the default for scenes"};
}

Denoising decided(Denoising asked, Integrator integrator) {
  if (asked != Denoising::automatic) return asked;
  return integrator == Integrator::whitted ? Denoising::off : Denoising::on;
}

PlaneSet shown_planes(Job const& job) {
  PlaneSet planes = job.planes;
  bool const is_transparent = job.background && !job.background->shown;
  if (is_transparent && planes.has(FilmPlane::radiance)) planes.add(FilmPlane::alpha);
  return planes;
}

PlaneSet traced_planes(Job const& job) {
  bool const is_denoised = job.denoising == Denoising::on || job.denoising == Denoising::builtin;
  return is_denoised ? with_guides(shown_planes(job)) : shown_planes(job);
}

Job resolved(Job job, Scene const& scene) {
  check_numbers(job);
  if (!job.planes.has(FilmPlane::radiance)) job.noise.reset();  // other planes have next to none
  RenderCommand const command = command_of(job, scene);
  Camera const camera = find_camera(job, scene, command.camera);
  job.camera = camera.name();
  if (!job.size) job.size = command.resolution;
  if (!job.size) job.size = camera.resolution();
  if (!job.size) job.size = scene.resolution.value_or(default_size);
  if (!job.region) job.region = whole_picture(*job.size);
  job.integrator = chosen_integrator(job, scene).integrator;
  if (!job.background && job.integrator == Integrator::path) job.background = usual_background(job, scene);
  Effort const usual =
      usual_effort(*job.integrator, is_model(job), job.view.aperture.value_or(camera.lens().aperture) > 0);
  constexpr int most_samples = 4096;  // where the noise decides
  int const samples = command.samples.value_or(job.noise ? most_samples : usual.samples);
  if (!job.sampling) job.sampling = sampling_of(samples);
  if (job.noise && job.samples) throw Error(ErrorKind::usage, "--noise: it takes all samples, not a range of them");
  if (job.noise && (job.sampling->pattern == Sampling::Pattern::grid || job.sampling->count <= Film::block_size)) {
    throw Error(ErrorKind::usage,
                fmt::format("--noise: --samples is the most to take, and must be above {} and no grid, "
                            "such as --samples {}",
                            Film::block_size, most_samples));
  }
  if (!job.max_depth) job.max_depth = command.depth.value_or(usual.max_depth);
  job.denoising = decided(job.denoising, *job.integrator);
  check_view(job.view);
  check_request(request_through(camera, job));
  return job;
}

RenderRequest request_of(Job const& job, Scene const& scene, std::optional<Vec3> const& turn_center) {
  Job const decided = resolved(job, scene);
  Camera const camera = viewpoint(find_camera(decided, scene, {}), job, scene, *decided.size);
  RenderRequest request = request_through(camera, decided);
  if (job.turn_degrees) {
    Vec3 const center = job.view.look_at ? *job.view.look_at
                        : turn_center    ? *turn_center
                                         : turn_center_of(job, scene, camera);
    request.camera = orbited(camera, center, *job.turn_degrees, job.view.up_in(scene));
  }
  return request;
}

Bounds bounds_in_view(Job const& job, Scene const& scene, Camera const& camera) {
  return job.view.orbit ? bounds_of_interest(scene, job.root) : bounds_of_interest(scene, job.root, camera);
}

Vec3 turn_center_of(Job const& job, Scene const& scene, Camera const& camera) {
  Bounds const box = bounds_in_view(job, scene, camera);
  return box.is_empty() ? Vec3(0) : box.center();
}

RenderRequest view_of(Job job, Scene const& scene) {
  job.region.reset();
  job.samples.reset();
  job.planes = {FilmPlane::radiance};
  job.denoising = Denoising::off;
  job.noise.reset();
  if (!job.sampling) job.sampling = Sampling();
  if (job.background && !job.background->shown) job.background->shown = Rgb(0);
  return request_of(job, scene);
}

Development development_of(Job const& job, Scene const& scene) {
  return {job.exposure_ev, job.tone_map == ToneMap::automatic ? usual_tone_map(job, scene) : job.tone_map,
          job.transfer ? *job.transfer : usual_transfer(job, scene)};
}

}  // namespace lichtraum
