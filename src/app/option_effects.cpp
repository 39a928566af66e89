#include "app/option_effects.hpp"

#include "lichtraum/gltf.hpp"

namespace lichtraum::app {

std::vector<OptionWithoutEffect> options_without_effect(SceneReading const& asked, bool is_model) {
  std::vector<OptionWithoutEffect> found;
  auto const is_of_models = [&](bool given, char const* option) {
    if (given && !is_model) found.push_back({option, ": a scene's models stand as in their files"});
  };
  ModelChoice const& model = asked.model;
  is_of_models(model.time_seconds.has_value(), "--time");
  is_of_models(!model.animation.empty(), "--animation");
  is_of_models(!model.variant.empty(), "--variant");
  is_of_models(!model.scene.empty(), "--scene");
  is_of_models(model.both_sides, "--both-sides");
  is_of_models(model.max_texture != ModelChoice().max_texture, "--max-texture");
  is_of_models(model.point_size.has_value(), "--point-size");
  auto const is_of_scenes = [&](bool given, char const* option) {
    if (given && is_model) found.push_back({option, ": it is for scenes in eSDF"});
  };
  EsdfDialect const& dialect = asked.dialect;
  EsdfDialect const standard;
  is_of_scenes(dialect.strict, "--strict");
  is_of_scenes(dialect.keep_going, "--keep-going");
  is_of_scenes(dialect.transform_order != standard.transform_order, "--transform-order");
  is_of_scenes(dialect.rotation != standard.rotation, "--rotation");
  is_of_scenes(!dialect.material_extras.empty(), "--material-extras");
  return found;
}

std::vector<OptionWithoutEffect> options_without_effect(Job const& asked, Job const& decided, bool is_model,
                                                        bool has_environment) {
  std::vector<OptionWithoutEffect> found;
  auto const has_no_effect = [&](bool given, bool applies, char const* option, char const* why = "") {
    if (given && !applies) found.push_back({option, why});
  };
  bool const is_by_paths = decided.integrator == Integrator::path;
  bool const has_radiance = traced_planes(decided).has(FilmPlane::radiance);
  has_no_effect(asked.background.has_value(), has_radiance, "--background");
  has_no_effect(asked.sampling.has_value(), traced_planes(decided).has(PlaneRule::mean), "--samples");
  has_no_effect(asked.noise.has_value(), has_radiance, "--noise");
  bool const has_shadows = decided.ground != Ground::none && traced_planes(decided).has(FilmPlane::alpha);
  bool const is_lit = has_radiance || has_shadows;
  has_no_effect(asked.max_indirect.has_value(), is_lit && is_by_paths, "--clamp");
  has_no_effect(asked.max_depth.has_value(), is_lit, "--depth");
  Vec3 const up = asked.view.up.value_or(Scene().up);
  bool const is_upright = up.x == 0 && up.z == 0 && up.y > 0;
  has_no_effect(asked.ground != Ground::none, is_lit && (is_upright || is_model), "--ground",
                is_lit ? ": under a scene it is level in y, whatever --up says" : "");
  auto const of_reading = options_without_effect(asked.reading, is_model);
  found.insert(found.end(), of_reading.begin(), of_reading.end());
  bool const is_at_rest = is_gltf_file(decided.scene) && !decided.reading.model.time_seconds;
  has_no_effect(is_model && !asked.reading.model.animation.empty(), !is_at_rest, "--animation",
                ": without --time, --frames or a film the model stands as in its file");
  has_no_effect(is_model && asked.reading.model.both_sides, is_by_paths, "--both-sides",
                ": whitted shows both sides anyway");
  bool const may_have_lens = !is_model || asked.view.aperture;
  has_no_effect(asked.seed != 0, is_by_paths || may_have_lens || decided.sampling->pattern == Sampling::Pattern::seeded,
                "--seed", ": nothing is random here");
  EnvironmentChoice const& environment = asked.reading.environment;
  bool const is_none = environment.source == "none";
  bool const is_shown = is_lit && is_by_paths && has_environment;
  char const* const why = !is_lit || is_none ? ""
                          : !is_by_paths     ? ": it lights pictures by --integrator path only"
                                             : ": the scene has no environment";
  has_no_effect(!environment.source.empty() && !is_none, is_shown, "--environment", why);
  has_no_effect(environment.rotation_degrees.has_value(), is_shown, "--environment-rotation", why);
  has_no_effect(environment.brightness.has_value(), is_shown, "--environment-brightness", why);
  return found;
}

}  // namespace lichtraum::app
