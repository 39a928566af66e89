#include "app/picture_findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/empty_view.hpp"
#include "app/picture_bands.hpp"

namespace lichtraum::app {
namespace {

/// The same view in few pixels, with few samples in each. It reaches nowhere beyond the whole one.
RenderRequest reduced(RenderRequest request) {
  constexpr int width = 64;
  constexpr Sampling few{Sampling::Pattern::seeded, 16};
  if (request.resolution.width <= width) return request;
  int const height = std::max(1, int(double(request.resolution.height) * width / request.resolution.width));
  request.resolution = {width, std::min(height, 4 * width)};
  request.region = whole_picture(request.resolution);
  // Where chance decides, one sample is far brighter or darker than their mean.
  bool const is_by_chance = request.integrator == Integrator::path && request.sampling.count > few.count;
  request.sampling = is_by_chance ? few : Sampling();
  return request;
}

Diagnostic warning(SourceLocation const& at, DiagnosticCode code, std::string message, std::string hint = {}) {
  return {Severity::warning, code, at, 1, std::move(message), {}, std::move(hint)};
}

/// "the camera 'eye'"; the one that --orbit makes has no name.
std::string name_in_text(Camera const& camera) {
  return camera.name().empty() ? "the camera" : fmt::format("the camera '{}'", camera.name());
}

/// Why a `render` does not show what is defined below it; empty for an empty name.
std::string hint_of_order(std::string_view what, std::string const& name) {
  if (name.empty()) return {};
  return fmt::format("the {} '{}' is defined below this render: statements run in order", what, name);
}

}  // namespace

void Sight::add(RayCounts const& rays, Film& film) {
  camera_rays_ += rays.camera;
  camera_hits_ += rays.camera_hits;
  has_normals_ = has_normals_ || !film.planes().has(FilmPlane::normal) ||
                 std::ranges::any_of(film.floats(FilmPlane::normal), [](float value) { return value != 0; });
  is_black_ = is_black_ && film.planes().has(FilmPlane::radiance) &&
              std::ranges::all_of(film.floats(FilmPlane::radiance), [](float value) { return value == 0; });
}

double Sight::white_share(PictureReady const& ready) const {
  double const seen = camera_rays_ > 0 ? double(camera_hits_) / double(camera_rays_) : 0;
  return whiteness_.share(seen, ready.background, ready.development);
}

void PictureFindings::begin(SceneOpened const& scene) {
  source_ = scene.source;
  is_model_ = scene.is_model;
  has_explained_view_ = false;
  has_told_of_light_ = false;
  has_told_of_white_ = false;
}

std::vector<Diagnostic> PictureFindings::of_scene(PictureReady const& ready, PicturePlan const& plan) {
  if (ready.number > 0) return {};
  std::vector<Diagnostic> found;
  std::uint64_t const left_out = ready.scene->statistics.unrepresentable;
  if (left_out > 0) {
    found.push_back(
        warning({source_->name(), 0, 0}, DiagnosticCode::shapes_left_out,
                fmt::format("{} left out: too large for the device, which has coordinates up to 1e18, or too small",
                            left_out == 1 ? "1 shape is" : fmt::format("{} shapes are", left_out))));
  }
  bool const is_lit = ready.request.planes.has(FilmPlane::radiance) || ready.request.planes.has(FilmPlane::alpha);
  if (ready.request.ground != Ground::none && is_lit && !std::isfinite(ready.scene->lowest_point)) {
    found.push_back(warning({}, DiagnosticCode::option_without_effect,
                            fmt::format("--ground has no effect on '{}': all that is drawn is infinite, so nothing "
                                        "stands on it",
                                        plan.output.shown)));
  }
  return found;
}

std::vector<Diagnostic> PictureFindings::of_picture(PictureReady const& ready, PicturePlan const& plan,
                                                    Sight const& sight) {
  std::vector<Diagnostic> found;
  bool const lacks_light =
      ready.light != SceneLight::some && !sight.is_empty() && ready.request.planes.has(FilmPlane::radiance);
  bool const is_whole = !options_.job.region;
  if ((lacks_light || (sight.is_black() && is_whole)) && !std::exchange(has_told_of_light_, true)) {
    found.push_back(lacks_light ? explain_missing_light(ready.light, plan) : explain_black_picture(ready, plan));
  }
  double const white = sight.white_share(ready);
  if (white > 0.5 && is_whole && !std::exchange(has_told_of_white_, true)) {
    found.push_back(explain_white_picture(ready, plan, white));
  }
  if (sight.is_empty() && is_whole && !std::exchange(has_explained_view_, true)) {
    found.push_back(explain_empty_view(ready, plan));
  }
  if (sight.shows_no_surface() && is_model_ && is_whole && !std::exchange(has_explained_view_, true)) {
    found.push_back(warning(
        plan.location, DiagnosticCode::empty_view,
        fmt::format("{} meets the backs of surfaces only, which glTF hides", name_in_text(ready.request.camera)),
        "--both-sides shows them"));
  }
  return found;
}

std::vector<Diagnostic> PictureFindings::predicted(PictureReady const& ready, PicturePlan const& plan) {
  renderer_.set_scene(ready.scene);
  std::vector<Diagnostic> found = of_scene(ready, plan);
  auto const shows_nothing = [](Sight const& sight) {
    return sight.is_empty() || sight.is_black() || sight.shows_no_surface();
  };
  auto const look = [&](RenderRequest const& request, Sight& sight) {
    Film film;
    RenderResult const result = renderer_.render(request, film);
    sight.add(result.statistics.rays, film);
    if (plan.output.format->encode && film.planes().has(FilmPlane::radiance)) {
      sight.add(renderer_.develop(std::move(film), ready.development), ready.development);
    }
  };
  Sight sight;
  look(reduced(ready.request), sight);
  if (shows_nothing(sight)) {
    sight = Sight();
    RenderRequest request = ready.request;
    for (Region const& band : bands_of(plan, !ready.denoiser.empty())) {
      request.region = band;
      look(request, sight);
      if (!shows_nothing(sight)) break;
    }
  }
  std::ranges::move(of_picture(ready, plan, sight), std::back_inserter(found));
  return found;
}

Diagnostic PictureFindings::explain_missing_light(SceneLight light, PicturePlan const& plan) const {
  if (light == SceneLight::unused) {
    return warning(plan.location, DiagnosticCode::no_light,
                   "nothing gives light: whitted does not show the light of an environment", "--integrator path does");
  }
  if (light == SceneLight::dimmed) {
    return warning(plan.location, DiagnosticCode::no_light, "nothing gives light: the environment's brightness is 0",
                   "--environment-brightness 1 shows it as it is");
  }
  std::string hint = hint_of_order("light", defined_below(plan).light);
  if (hint.empty()) {
    hint =
        is_model_ ? "--integrator path --environment studio lights models" : "define light diffuse lamp 10 10 10 1 1 1";
  }
  return warning(plan.location, DiagnosticCode::no_light,
                 "nothing gives light: there is no lamp, no ambient light, no environment and no surface that shines",
                 std::move(hint));
}

Diagnostic PictureFindings::explain_black_picture(PictureReady const& ready, PicturePlan const& plan) const {
  std::string hint = hint_of_order("light", defined_below(plan).light);
  if (hint.empty()) hint = "perhaps every lamp is inside a shape or outside the room, or the materials reflect nothing";
  return warning(plan.location, DiagnosticCode::black_picture,
                 fmt::format("the picture is black: no light reaches what {} sees", name_in_text(ready.request.camera)),
                 std::move(hint));
}

Diagnostic PictureFindings::explain_white_picture(PictureReady const& ready, PicturePlan const& plan,
                                                  double share) const {
  Development const& development = ready.development;
  bool const may_map = development.tone_map == ToneMap::none;
  return warning(plan.location, DiagnosticCode::white_picture,
                 fmt::format("the picture is too bright: {:.0f} % of what it shows is pure white", 100 * share),
                 fmt::format("--exposure {:g} darkens it{}", development.exposure_ev - 2,
                             may_map ? ", and --tonemap neutral shows what is brighter than white" : ""));
}

PictureFindings::DefinedBelow PictureFindings::defined_below(PicturePlan const& plan) const {
  if (is_model_ || options_.is_merging) return {};
  LoadedScene script = source_->load(options_.job.reading, options_.load);
  Scene const& end = script.scene();
  DefinedBelow below;
  script.play([&](Scene const& scene, std::size_t index) {
    if (index != plan.scene_number) return true;
    std::size_t const shapes = scene.shapes.size(), lights = scene.lights.size();
    if (shapes < end.shapes.size()) below.shape = std::next(end.shapes.begin(), std::ptrdiff_t(shapes))->get()->name();
    if (lights < end.lights.size()) below.light = std::next(end.lights.begin(), std::ptrdiff_t(lights))->name();
    if (below.light.empty() && end.environment && !scene.environment) below.light = end.environment->name;
    return false;
  });
  return below;
}

/// Says where the scene lies, and which other convention would show it.
Diagnostic PictureFindings::explain_empty_view(PictureReady const& ready, PicturePlan const& plan) {
  Diagnostic result =
      warning(plan.location, DiagnosticCode::empty_view,
              fmt::format("{} sees nothing: {}", name_in_text(ready.request.camera),
                          describe_direction(ready.request.camera, ready.request.resolution, ready.scene->bounds)),
              hint_of_order("shape", defined_below(plan).shape));
  if (!result.hint.empty()) return result;
  for (Convention const& convention : other_conventions(options_.job.reading.dialect)) {
    if (is_model_ || options_.is_merging || !shows_something(convention.dialect, ready.request, plan.scene_number))
      continue;
    result.hint = fmt::format("with {} it is in view", convention.arguments);
    break;
  }
  return result;
}

/// Draws the picture again, small, from the file read under other options.
bool PictureFindings::shows_something(EsdfDialect const& dialect, RenderRequest request, std::size_t wanted) {
  request = reduced(std::move(request));
  request.planes = {FilmPlane::depth};
  bool is_seen = false;
  SceneReading reading = options_.job.reading;
  reading.dialect = dialect;
  LoadedScene script = source_->load(reading, options_.load);
  script.play([&](Scene const& scene, std::size_t index) {
    Camera const* const camera = scene.cameras.find(request.camera.name());
    if (index != wanted || !camera) return true;
    request.camera = camera->fitted(request.resolution);
    renderer_.set_scene(scene, options_.job.root);
    Film film;
    is_seen = renderer_.render(request, film).statistics.rays.camera_hits > 0;
    return false;
  });
  return is_seen;
}

}  // namespace lichtraum::app
