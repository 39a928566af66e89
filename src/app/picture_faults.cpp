#include "app/picture_faults.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>

#include "app/empty_view.hpp"
#include "lichtraum/job.hpp"

namespace lichtraum::app {
namespace {

constexpr double most_white = 0.5;  // of what a picture shows
constexpr double most_black = 0.9;
/// How many of its own sizes a scene may lie from the origin before reflections and shadows show that floats tell no
/// more than 2,000 places apart in it. (Readers move models from 1,000 on, as it costs nothing there.)
constexpr double most_sizes = 10'000;

Diagnostic warning(DiagnosticCode code, std::string message, std::string hint = {}) {
  return {Severity::warning, code, {}, 1, std::move(message), {}, std::move(hint)};
}

/// "the camera 'eye'"; the one that --orbit makes has no name.
std::string name_in_text(Camera const& camera) {
  return camera.name().empty() ? "the camera" : fmt::format("the camera '{}'", camera.name());
}

std::optional<Diagnostic> far_scene(Bounds const& bounds) {
  if (bounds.is_empty() || !bounds.is_finite()) return std::nullopt;
  auto const largest = [](Vec3 const& v) { return std::max({v.x, v.y, v.z}); };
  double const size = largest(bounds.max - bounds.min);
  double const distance = largest(glm::max(glm::abs(bounds.min), glm::abs(bounds.max)));
  if (distance <= most_sizes * size) return std::nullopt;
  Vec3 const offset = Vec3(0) - bounds.center();
  return warning(
      DiagnosticCode::far_scene,
      fmt::format("the scene is {:.3g} across and {:.3g} from the origin, where the device's numbers are {:.2g} apart: "
                  "details are lost",
                  size, distance, distance * double(std::numeric_limits<float>::epsilon())),
      fmt::format("move it, with its cameras and lights, by {:g} {:g} {:g}", offset.x, offset.y, offset.z));
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

/// Whether light may be behind more glass or mirrors than rays were followed through. Paths of the usual depth get
/// through all that there is.
bool may_end_early(RenderRequest const& request, Sight const& sight) {
  constexpr int deep_path = 64;
  int const depth = request.max_depth;
  bool const is_deep = depth >= (request.integrator == Integrator::path ? deep_path : job_limits::depth);
  return !is_deep && sight.may_reach_depth(depth);
}

Diagnostic black_picture(DrawnPicture const& drawn, Sight const& sight) {
  int const depth = drawn.request.max_depth;
  std::string hint = "perhaps every lamp is inside a shape or outside the room, or the materials reflect nothing";
  if (may_end_early(drawn.request, sight)) {
    hint +=
        fmt::format("; or light is behind more glass or mirrors than rays were followed through, {}: try --depth {}",
                    depth, std::clamp(4 * depth, 20, job_limits::depth));
  }
  return warning(DiagnosticCode::black_picture,
                 fmt::format("the picture is black: no light reaches what {} sees", name_in_text(drawn.request.camera)),
                 std::move(hint));
}

Diagnostic dark_picture(DrawnPicture const& drawn, double share) {
  return warning(
      DiagnosticCode::black_picture,
      fmt::format("the picture is nearly black: next to no light reaches {:.0f} % of what {} sees", 100 * share,
                  name_in_text(drawn.request.camera)),
      fmt::format("--exposure {:g} brightens it; a closed room needs a lamp in it", drawn.development.exposure_ev + 4));
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
  secondary_rays_ += rays.secondary;
  has_normals_ = has_normals_ || !film.planes().has(FilmPlane::normal) ||
                 std::ranges::any_of(film.floats(FilmPlane::normal), [](float value) { return value != 0; });
  is_black_ = is_black_ && film.planes().has(FilmPlane::radiance) &&
              std::ranges::all_of(film.floats(FilmPlane::radiance), [](float value) { return value == 0; });
}

double Sight::white_share(Background const& background, Development const& development) const {
  return extremes_.white_share(seen(), background, development);
}

double Sight::black_share(Background const& background, Development const& development) const {
  return extremes_.black_share(seen(), background, development);
}

std::vector<std::pair<PictureFault, Diagnostic>> faults_of(DrawnPicture const& drawn, Sight const& sight) {
  std::vector<std::pair<PictureFault, Diagnostic>> found;
  if (auto far = far_scene(drawn.bounds)) found.emplace_back(PictureFault::far_away, std::move(*far));
  if (!drawn.map_repairs.empty()) {
    found.emplace_back(PictureFault::repaired_map,
                       warning(DiagnosticCode::repaired_environment, std::string(drawn.map_repairs)));
  }
  bool const lacks_light =
      drawn.light != SceneLight::some && !sight.is_empty() && drawn.request.planes.has(FilmPlane::radiance);
  if (lacks_light) {
    found.emplace_back(PictureFault::no_light, missing_light(drawn));
  } else if (sight.is_black() && drawn.is_whole) {
    found.emplace_back(PictureFault::no_light, black_picture(drawn, sight));
  }
  if (!drawn.is_whole) return found;
  bool const lacks_none =
      std::ranges::none_of(found, [](auto const& fault) { return fault.first == PictureFault::no_light; });
  double const black = drawn.is_model ? sight.black_share(drawn.background, drawn.development) : 0;
  if (lacks_none && black > most_black) found.emplace_back(PictureFault::no_light, dark_picture(drawn, black));
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
