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

Diagnostic warning(SourceLocation const& at, DiagnosticCode code, std::string message) {
  return {Severity::warning, code, at, 1, std::move(message), {}, {}};
}

/// Why a `render` does not show what is defined below it; empty for an empty name.
std::string hint_of_order(std::string_view what, std::string const& name) {
  if (name.empty()) return {};
  return fmt::format("the {} '{}' is defined below this render: statements run in order", what, name);
}

}  // namespace

void PictureFindings::begin(SceneOpened const& scene) {
  source_ = scene.source;
  is_model_ = scene.is_model;
  told_.clear();
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
  DrawnPicture const drawn{ready.request, ready.development, ready.background,     ready.scene->bounds,
                           ready.light,   is_model_,         !options_.job.region, ready.map_repairs};
  std::vector<Diagnostic> found;
  for (auto& [fault, finding] : faults_of(drawn, sight)) {
    if (!told_.insert(fault).second) continue;
    finding.location = plan.location;
    std::string const better = better_hint(fault, plan);
    if (!better.empty()) finding.hint = better;
    found.push_back(std::move(finding));
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

PictureFindings::DefinedBelow PictureFindings::defined_below(PicturePlan const& plan) const {
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

/// What the file tells about it: that something is defined too late, or that another convention would show it. Empty
/// where it tells nothing.
std::string PictureFindings::better_hint(PictureFault fault, PicturePlan const& plan) {
  if (is_model_ || options_.is_merging) return {};
  if (fault == PictureFault::no_light) return hint_of_order("light", defined_below(plan).light);
  if (fault != PictureFault::nothing_seen) return {};
  std::string hint = hint_of_order("shape", defined_below(plan).shape);
  if (!hint.empty()) return hint;
  for (Convention const& convention : other_conventions(options_.job.reading.dialect)) {
    if (shows_something(convention.dialect, plan)) {
      return fmt::format("with {} it is in view", convention.arguments);
    }
  }
  return {};
}

/// Draws the picture again, small, from the file read under other options.
bool PictureFindings::shows_something(EsdfDialect const& dialect, PicturePlan plan) {
  plan.job.reading.dialect = dialect;
  bool is_seen = false;
  LoadedScene script = source_->load(plan.job.reading, options_.load);
  script.play([&](Scene const& scene, std::size_t index) {
    if (index != plan.scene_number) return true;
    try {
      std::optional<Vec3> turn_center;
      RenderRequest request = reduced(request_for(plan, scene, turn_center));
      request.planes = {FilmPlane::depth};
      renderer_.set_scene(scene, options_.job.root);
      Film film;
      is_seen = renderer_.render(request, film).statistics.rays.camera_hits > 0;
    } catch (Error const& error) {
      if (error.kind() != ErrorKind::usage) throw;  // read so, the options do not fit
    }
    return false;
  });
  return is_seen;
}

}  // namespace lichtraum::app
