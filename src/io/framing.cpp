#include "io/framing.hpp"

#include <algorithm>

#include "lichtraum/orbit.hpp"

namespace lichtraum {

Camera frame_box(std::string name, Bounds const& box, Vec3 const& up) {
  constexpr double fov_degrees = 45;
  constexpr Resolution resolution{1024, 768};
  Bounds const seen = box.is_empty() ? Bounds{Vec3(-1), Vec3(1)} : box;
  Camera camera(std::move(name), fov_degrees, orbit_rotation(three_quarter_view, up), resolution);
  CameraFit const fit{CameraFit::Side::longer, fov_degrees, CameraFit::Framed{seen}};
  camera.set_fit(fit);
  camera = camera.fitted(resolution);
  camera.set_fit(fit);
  return camera;
}

std::vector<Light> studio_lights(Bounds const& box, double viewer_azimuth_degrees, Vec3 const& up) {
  Bounds const lit = box.is_empty() ? Bounds{Vec3(-1), Vec3(1)} : box;
  Vec3 const center = lit.center();
  // At most so large that no lamp is infinitely far away, however far the center is.
  double const size = std::clamp(glm::length(lit.max - lit.min), 1e-30, 1e290);
  // Far away for their size: nearly parallel light, so that no part of the model is much brighter than another.
  double const distance = 10 * size;
  Transform const viewer = orbit_rotation({viewer_azimuth_degrees, 0}, up);
  auto const towards = [&](Vec3 const& direction) { return viewer.vector(distance * glm::normalize(direction)); };
  return {Light::point("key", center + towards({0.6, 1, 0.9}), Rgb(0.8)),
          Light::point("fill", center + towards({-1, 0.3, 0.6}), Rgb(0.3)), Light::ambient("soft", Rgb(0.2))};
}

}  // namespace lichtraum
