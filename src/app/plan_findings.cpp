#include "app/plan_findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/option_effects.hpp"
#include "core/largest_channel.hpp"

namespace lichtraum::app {
namespace {

Diagnostic warning(DiagnosticCode code, SourceLocation const& location, std::string message, std::string hint = {}) {
  return {Severity::warning, code, location, 1, std::move(message), {}, std::move(hint)};
}

}  // namespace

std::optional<Diagnostic> PlanFindings::film_of_one_picture(SceneOpened const& scene) const {
  if (inputs_ > 1 || scene.plans.size() != 1 || !scene.plans.front().output.is_film) return std::nullopt;
  bool const lacks_animation = scene.is_model && !scene.animation;
  return warning(DiagnosticCode::film_of_one_picture, {scene.source->name(), 0, 0},
                 fmt::format("the film '{}' is one picture, shown for {:.2g} s{}", scene.plans.front().output.shown,
                             1 / options_.frame_rate(), lacks_animation ? ": the model has no animation" : ""),
                 "--turntable 90 circles what is in view");
}

std::optional<Diagnostic> PlanFindings::outside_animation(SceneOpened const& scene) const {
  if (!scene.animation) return std::nullopt;
  double const end = scene.animation->seconds;
  auto const is_outside = [&](PicturePlan const& plan) {
    auto const& time = plan.job.reading.model.time_seconds;
    return time && (*time < 0 || *time > end);
  };
  auto const first = std::ranges::find_if(scene.plans, is_outside);
  if (first == scene.plans.end()) return std::nullopt;
  SourceLocation const location{scene.source->name(), 0, 0};
  if (!options_.frames) {
    return warning(DiagnosticCode::outside_animation, location,
                   fmt::format("the animation is {:.6g} s long: at {:.6g} s it stands still", end,
                               *first->job.reading.model.time_seconds));
  }
  return warning(DiagnosticCode::outside_animation, location,
                 fmt::format("the animation is {:.6g} s long: in {} of the {} frames it stands still", end,
                             std::ranges::count_if(scene.plans, is_outside), scene.plans.size()),
                 fmt::format("--frames 0..{:.0f} shows all of it", std::floor(end * options_.frame_rate())));
}

/// Colours of eight bits, as most programs give them.
std::optional<Diagnostic> PlanFindings::background_of_bytes() {
  constexpr double brightest = 16;  // of what is likely meant
  auto const& asked = options_.job.background;
  if (!asked || !asked->shown || has_told_of_background_) return std::nullopt;
  Rgb const largest = glm::max(asked->shown->top, asked->shown->bottom);
  if (largest_channel(largest) <= brightest) return std::nullopt;
  has_told_of_background_ = true;
  return warning(DiagnosticCode::color_out_of_range, {}, "--background: its colours are linear, and 1 is white",
                 "write colours from 0 to 255 as '#rrggbb', which is sRGB");
}

std::vector<Diagnostic> PlanFindings::next(SceneOpened const& scene) {
  std::vector<Diagnostic> found;
  auto const warn = [&](DiagnosticCode code, SourceLocation const& location, std::string message,
                        std::string hint = {}) {
    found.push_back(warning(code, location, std::move(message), std::move(hint)));
  };
  for (auto const& finding : {film_of_one_picture(scene), outside_animation(scene), background_of_bytes()}) {
    if (finding) found.push_back(*finding);
  }
  for (PicturePlan const& plan : scene.plans) {
    ImageFormat const& format = *plan.output.format;
    bool const is_own_file = !plan.output.is_standard_output() && !plan.output.is_film;
    int const use = is_own_file ? ++uses_[plan.output.path] : 1;
    if (use == 2) {
      warn(DiagnosticCode::name_used_twice, plan.location,
           fmt::format("several pictures are called '{}': the last one is kept", plan.output.shown),
           "-o picture-%04d.png numbers them");
    }
    if (use > 1) continue;
    if (!plan.output.note.empty()) warn(DiagnosticCode::other_format, plan.location, plan.output.note);
    auto const warn_once = [&](char const* option, char const* why) {
      if (!warned_.insert({option, plan.output.path.extension()}).second) return;
      warn(DiagnosticCode::option_without_effect, {},
           fmt::format("{} has no effect on '{}'{}", option, plan.output.shown, why));
    };
    auto const has_no_effect = [&](bool given, bool applies, char const* option, char const* why = "") {
      if (given && !applies) warn_once(option, why);
    };
    bool const is_film = plan.output.is_film;
    has_no_effect(options_.has_bits, format.encode && format.max_bits > 8 && !is_film, "--bits");
    has_no_effect(options_.has_quality, format.name == "jpg", "--quality");
    has_no_effect(options_.job.encoding.ppm_ascii, format.name == "ppm" && !is_film, "--ppm-ascii");
    bool const has_radiance = traced_planes(plan.job).has(FilmPlane::radiance);
    bool const has_color = has_radiance || traced_planes(plan.job).has(FilmPlane::albedo);
    has_no_effect(options_.job.exposure_ev != 0, format.encode && has_radiance, "--exposure");
    has_no_effect(options_.job.tone_map != ToneMap::automatic, format.encode && has_radiance, "--tonemap");
    has_no_effect(options_.job.transfer.has_value(), format.encode && has_color, "--transfer");
    Denoising const denoising = options_.job.denoising;
    has_no_effect(denoising == Denoising::on || denoising == Denoising::builtin, format.encode && has_radiance,
                  "--denoise",
                  format.encode_film && has_radiance ? ": planes are stored as traced (lichtraum denoise)" : "");
    for (auto const& [option, why] :
         options_without_effect(options_.job, plan.job, scene.is_model, scene.has_environment)) {
      warn_once(option, why);
    }
    has_no_effect(options_.resume, format.read_fingerprint != nullptr, "--resume");
  }
  return found;
}

}  // namespace lichtraum::app
