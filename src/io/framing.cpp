#include "io/framing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/trigonometric.hpp>

#include "core/elementary.hpp"

namespace lichtraum {
namespace {

std::array<Vec3, 8> corners_of(Bounds const& box) {
  std::array<Vec3, 8> corners;
  for (int i = 0; i < 8; ++i) corners[std::size_t(i)] = corner_of(box, i);
  return corners;
}

}  // namespace

Camera frame_box(std::string name, Bounds const& box) {
  constexpr double fov_x_degrees = 45;
  constexpr double elevation_degrees = 15;
  constexpr double margin = 1.1;
  constexpr Resolution resolution{1024, 768};
  Bounds const seen = box.is_empty() ? Bounds{Vec3(-1), Vec3(1)} : box;
  Vec3 const center = seen.center();
  double const elevation = glm::radians(elevation_degrees);
  Vec3 const back(0, sin_of(elevation), cos_of(elevation));  // from the centre to the camera
  Transform const world_from_camera_frame = Transform::look_along(Vec3(0), -back, Vec3(0, 1, 0));
  double const tan_x = tan_of(glm::radians(fov_x_degrees) / 2);
  double const tan_y = tan_x * resolution.height / resolution.width;
  double distance = 0;
  for (Vec3 const& corner : corners_of(seen)) {
    // As seen from the centre: x to the right, y up, z towards the camera.
    Vec3 const p = world_from_camera_frame.inverse().vector(corner - center);
    distance = std::max({distance, p.z + margin * std::abs(p.x) / tan_x, p.z + margin * std::abs(p.y) / tan_y});
  }
  if (!(distance > 0)) distance = 1;  // a single point
  return Camera(std::move(name), fov_x_degrees,
                Transform::translation(center + distance * back) * world_from_camera_frame, resolution);
}

std::vector<Light> studio_lights(Bounds const& box) {
  Bounds const lit = box.is_empty() ? Bounds{Vec3(-1), Vec3(1)} : box;
  Vec3 const center = lit.center();
  double const size = std::max(glm::length(lit.max - lit.min), 1e-30);
  // Far away for their size: nearly parallel light, so that no part of the model is much brighter than another.
  double const distance = 10 * size;
  return {Light::point("key", center + distance * glm::normalize(Vec3(0.6, 1, 0.9)), Rgb(0.8)),
          Light::point("fill", center + distance * glm::normalize(Vec3(-1, 0.3, 0.6)), Rgb(0.3)),
          Light::ambient("soft", Rgb(0.2))};
}

}  // namespace lichtraum
