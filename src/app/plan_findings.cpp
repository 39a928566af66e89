#include "app/plan_findings.hpp"

#include <fmt/format.h>

namespace lichtraum::app {

std::vector<Diagnostic> PlanFindings::next(SceneOpened const& scene) {
  std::vector<Diagnostic> found;
  auto const warn = [&](DiagnosticCode code, SourceLocation const& location, std::string message,
                        std::string hint = {}) {
    found.push_back({Severity::warning, code, location, 1, std::move(message), {}, std::move(hint)});
  };
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
    auto const has_no_effect = [&](bool given, bool applies, char const* option, char const* advice = "") {
      if (!given || applies || !warned_.insert({option, plan.output.path.extension()}).second) return;
      warn(DiagnosticCode::option_without_effect, {},
           fmt::format("{} has no effect on '{}'{}", option, plan.output.shown, advice));
    };
    bool const is_film = plan.output.is_film;
    has_no_effect(options_.has_bits, format.encode && format.max_bits > 8 && !is_film, "--bits");
    has_no_effect(options_.has_quality, format.name == "jpg", "--quality");
    has_no_effect(options_.job.encoding.ppm_ascii, format.name == "ppm" && !is_film, "--ppm-ascii");
    bool const has_radiance = traced_planes(plan.job).has(FilmPlane::radiance);
    has_no_effect(options_.has_development, format.encode && has_radiance, "--exposure, --tonemap or --transfer");
    Denoising const denoising = options_.job.denoising;
    has_no_effect(denoising == Denoising::on || denoising == Denoising::builtin, format.encode && has_radiance,
                  "--denoise",
                  format.encode_film && has_radiance ? ": planes are stored as traced (lichtraum denoise)" : "");
    has_no_effect(options_.job.background.has_value(), has_radiance, "--background");
    has_no_effect(options_.job.sampling.has_value(), traced_planes(plan.job).has(PlaneRule::mean), "--samples");
    has_no_effect(options_.job.noise.has_value(), has_radiance, "--noise");
    bool const has_shadows = plan.job.ground != Ground::none && traced_planes(plan.job).has(FilmPlane::alpha);
    bool const is_lit = has_radiance || has_shadows;
    has_no_effect(options_.job.max_indirect.has_value(), is_lit && plan.job.integrator == Integrator::path, "--clamp");
    has_no_effect(options_.job.max_depth.has_value(), is_lit, "--depth");
    Vec3 const up = options_.job.view.up.value_or(Vec3(0, 1, 0));
    bool const is_upright = up.x == 0 && up.z == 0 && up.y > 0;
    has_no_effect(options_.job.ground != Ground::none, is_lit && (is_upright || scene.is_model), "--ground",
                  is_lit ? ": under a scene it is level in y, whatever --up says" : "");
    ModelChoice const& model = options_.job.reading.model;
    bool const is_posed = model.time_seconds || !model.animation.empty();
    constexpr char const* as_in_files = ": a scene's models stand as in their files";
    has_no_effect(is_posed, scene.is_model, "--time or --animation", as_in_files);
    has_no_effect(!model.variant.empty(), scene.is_model, "--variant", as_in_files);
    has_no_effect(!model.scene.empty(), scene.is_model, "--scene", as_in_files);
    has_no_effect(model.both_sides, scene.is_model, "--both-sides", as_in_files);
    has_no_effect(model.max_texture != ModelChoice().max_texture, scene.is_model, "--max-texture", as_in_files);
    has_no_effect(model.point_size.has_value(), scene.is_model, "--point-size", as_in_files);
    EnvironmentChoice const& environment = options_.job.reading.environment;
    bool const is_none = environment.source == "none";
    bool const has_environment = is_lit && plan.job.integrator == Integrator::path && scene.has_environment;
    char const* const why = !is_lit || is_none                        ? ""
                            : plan.job.integrator != Integrator::path ? ": it lights pictures by --integrator path only"
                                                                      : ": the scene has no environment";
    has_no_effect(!environment.source.empty() && !is_none, has_environment, "--environment", why);
    has_no_effect(environment.rotation_degrees.has_value(), has_environment, "--environment-rotation", why);
    has_no_effect(environment.brightness.has_value(), has_environment, "--environment-brightness", why);
    has_no_effect(options_.resume, format.read_fingerprint != nullptr, "--resume");
  }
  return found;
}

}  // namespace lichtraum::app
