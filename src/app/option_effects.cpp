#include "app/option_effects.hpp"

#include "lichtraum/gltf.hpp"

namespace lichtraum::app {

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
  Vec3 const up = asked.view.up.value_or(Vec3(0, 1, 0));
  bool const is_upright = up.x == 0 && up.z == 0 && up.y > 0;
  has_no_effect(asked.ground != Ground::none, is_lit && (is_upright || is_model), "--ground",
                is_lit ? ": under a scene it is level in y, whatever --up says" : "");
  ModelChoice const& model = asked.reading.model;
  constexpr char const* as_in_files = ": a scene's models stand as in their files";
  has_no_effect(model.time_seconds.has_value(), is_model, "--time", as_in_files);
  bool const is_at_rest = is_gltf_file(decided.scene) && !decided.reading.model.time_seconds;
  has_no_effect(!model.animation.empty(), is_model && !is_at_rest, "--animation",
                is_model ? ": without --time, --frames or a film the model stands as in its file" : as_in_files);
  has_no_effect(!model.variant.empty(), is_model, "--variant", as_in_files);
  has_no_effect(!model.scene.empty(), is_model, "--scene", as_in_files);
  has_no_effect(model.both_sides, is_model && is_by_paths, "--both-sides",
                is_model ? ": whitted shows both sides anyway" : as_in_files);
  has_no_effect(model.max_texture != ModelChoice().max_texture, is_model, "--max-texture", as_in_files);
  has_no_effect(model.point_size.has_value(), is_model, "--point-size", as_in_files);
  EsdfDialect const& dialect = asked.reading.dialect;
  EsdfDialect const standard;
  constexpr char const* of_scenes = ": it is for scenes in eSDF";
  has_no_effect(dialect.strict, !is_model, "--strict", of_scenes);
  has_no_effect(dialect.keep_going, !is_model, "--keep-going", of_scenes);
  has_no_effect(dialect.transform_order != standard.transform_order, !is_model, "--transform-order", of_scenes);
  has_no_effect(dialect.rotation != standard.rotation, !is_model, "--rotation", of_scenes);
  has_no_effect(!dialect.material_extras.empty(), !is_model, "--material-extras", of_scenes);
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
