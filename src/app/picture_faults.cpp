#include "app/picture_faults.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/empty_view.hpp"

namespace lichtraum::app {
namespace {

constexpr double most_white = 0.5;  // of what a picture shows

Diagnostic warning(DiagnosticCode code, std::string message, std::string hint = {}) {
  return {Severity::warning, code, {}, 1, std::move(message), {}, std::move(hint)};
}

/// "the camera 'eye'"; the one that --orbit makes has no name.
std::string name_in_text(Camera const& camera) {
  return camera.name().empty() ? "the camera" : fmt::format("the camera '{}'", camera.name());
}

Diagnostic missing_light(DrawnPicture const& drawn) {
  if (drawn.light == SceneLight::unused) {
    return warning(DiagnosticCode::no_light, "nothing gives light: whitted does not show the light of an environment",
                   "--integrator path does");
  }
  if (drawn.light == SceneLight::dimmed) {
    return warning(DiagnosticCode::no_light, "nothing gives light: the environment's brightness is 0",
                   "--environment-brightness 1 shows it as it is");
  }
  return warning(DiagnosticCode::no_light,
                 "nothing gives light: there is no lamp, no ambient light, no environment and no surface that shines",
                 drawn.is_model ? "--integrator path --environment studio lights models"
                                : "define light diffuse lamp 10 10 10 1 1 1");
}

Diagnostic black_picture(DrawnPicture const& drawn) {
  return warning(DiagnosticCode::black_picture,
                 fmt::format("the picture is black: no light reaches what {} sees", name_in_text(drawn.request.camera)),
                 "perhaps every lamp is inside a shape or outside the room, or the materials reflect nothing");
}

Diagnostic white_picture(DrawnPicture const& drawn, double share) {
  bool const may_map = drawn.development.tone_map == ToneMap::none;
  return warning(DiagnosticCode::white_picture,
                 fmt::format("the picture is too bright: {:.0f} % of what it shows is pure white", 100 * share),
                 fmt::format("--exposure {:g} darkens it{}", drawn.development.exposure_ev - 2,
                             may_map ? ", and --tonemap neutral shows what is brighter than white" : ""));
}

Diagnostic empty_view(DrawnPicture const& drawn) {
  Camera const& camera = drawn.request.camera;
  return warning(DiagnosticCode::empty_view,
                 fmt::format("{} sees nothing: {}", name_in_text(camera),
                             describe_direction(camera, drawn.request.resolution, drawn.bounds)));
}

Diagnostic backs_only(DrawnPicture const& drawn) {
  return warning(
      DiagnosticCode::empty_view,
      fmt::format("{} meets the backs of surfaces only, which glTF hides", name_in_text(drawn.request.camera)),
      "--both-sides shows them");
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

double Sight::white_share(Background const& background, Development const& development) const {
  double const seen = camera_rays_ > 0 ? double(camera_hits_) / double(camera_rays_) : 0;
  return whiteness_.share(seen, background, development);
}

std::vector<std::pair<PictureFault, Diagnostic>> faults_of(DrawnPicture const& drawn, Sight const& sight) {
  std::vector<std::pair<PictureFault, Diagnostic>> found;
  bool const lacks_light =
      drawn.light != SceneLight::some && !sight.is_empty() && drawn.request.planes.has(FilmPlane::radiance);
  if (lacks_light) {
    found.emplace_back(PictureFault::no_light, missing_light(drawn));
  } else if (sight.is_black() && drawn.is_whole) {
    found.emplace_back(PictureFault::no_light, black_picture(drawn));
  }
  if (!drawn.is_whole) return found;
  double const white = sight.white_share(drawn.background, drawn.development);
  if (white > most_white) found.emplace_back(PictureFault::too_bright, white_picture(drawn, white));
  if (sight.is_empty()) {
    found.emplace_back(PictureFault::nothing_seen, empty_view(drawn));
  } else if (sight.shows_no_surface() && drawn.is_model) {
    found.emplace_back(PictureFault::nothing_seen, backs_only(drawn));
  }
  return found;
}

}  // namespace lichtraum::app
