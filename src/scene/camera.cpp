#include "lichtraum/camera.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <ostream>
#include <stdexcept>

#include "core/elementary.hpp"
#include "core/format_numbers.hpp"
#include "scene/unit_vector.hpp"

namespace lichtraum {

namespace {

void check_fov(double degrees) {
  if (!(degrees > 0 && degrees < 180)) {
    throw std::invalid_argument("a camera's opening angle must lie between 0 and 180 degrees");
  }
}

/// Half of the picture's width at distance 1.
double half_width_of(double fov_x_degrees) { return tan_of(glm::radians(fov_x_degrees) / 2); }

double fov_x_of(CameraFit const& fit, Resolution const& size) {
  bool const is_width =
      fit.side == CameraFit::Side::width || (fit.side == CameraFit::Side::longer && size.width >= size.height);
  if (is_width) return fit.fov_degrees;
  double const fov = glm::degrees(2 * atan2_of(half_width_of(fit.fov_degrees) * size.width, size.height));
  return std::clamp(fov, 1e-12, std::nextafter(180.0, 0.0));  // roundings must not make it none
}

/// How far from the center a camera must stand to see all of the box. 0: it is a point.
double framing_distance(CameraFit::Framed const& framed, Transform const& rotation, double half_width,
                        double half_height) {
  constexpr double margin = 1.03;  // little, as hardly anything fills its box
  double distance = 0;
  for (int i = 0; i < 8; ++i) {
    // As seen from the center: x to the right, y up, z towards the camera.
    Vec3 const p = rotation.inverse().vector(corner_of(framed.box, i) - framed.center);
    distance =
        std::max({distance, p.z + margin * std::abs(p.x) / half_width, p.z + margin * std::abs(p.y) / half_height});
  }
  return distance;
}

/// The same, from wherever it turns to.
double turning_distance(CameraFit::Framed const& framed, Transform const& rotation, double half_width,
                        double half_height) {
  if (framed.turn_axis == Vec3(0)) return framing_distance(framed, rotation, half_width, half_height);
  constexpr int steps = 120;  // between which a corner comes no nearer than by a thousandth
  double distance = 0;
  for (int i = 0; i < steps; ++i) {
    Transform const turned = Transform::rotation(i * 360.0 / steps, framed.turn_axis) * rotation;
    distance = std::max(distance, framing_distance(framed, turned, half_width, half_height));
  }
  return distance;
}

}  // namespace

Camera::Camera(std::string name, double fov_x_degrees, Transform const& world_from_camera,
               std::optional<Resolution> resolution)
    : name_(std::move(name)),
      fov_x_degrees_(fov_x_degrees),
      resolution_(resolution),
      world_from_camera_(world_from_camera) {
  check_fov(fov_x_degrees);
}

void Camera::set_fit(CameraFit const& fit) {
  check_fov(fit.fov_degrees);
  fit_ = fit;
}

void Camera::set_lens(Lens const& lens) {
  bool const is_good = lens.aperture >= 0 && std::isfinite(lens.aperture) && lens.focus_distance > 0 &&
                       std::isfinite(lens.focus_distance);
  if (!is_good) throw std::invalid_argument("a lens needs an aperture of at least 0 and a focus distance above 0");
  lens_ = lens;
}

Camera Camera::fitted(Resolution const& size) const {
  if (!fit_) return *this;
  Camera result(name_, fov_x_of(*fit_, size), world_from_camera_, resolution_);
  result.lens_ = lens_;
  if (!fit_->framed) return result;
  Transform const rotation = Transform::translation(-world_from_camera_.point(Vec3(0))) * world_from_camera_;
  double const half_width = half_width_of(result.fov_x_degrees());
  double const needed = turning_distance(*fit_->framed, rotation, half_width, half_width * size.height / size.width);
  double const distance = needed > 0 ? needed : 1;  // of a single point
  result.set_world_from_camera(
      Transform::translation(fit_->framed->center + distance * rotation.vector(Vec3(0, 0, 1))) * rotation);
  return result;
}

Ray Camera::generate_ray(double x, double y, Resolution const& size, double lens_x, double lens_y) const {
  double const pixel = 2 * half_width_of(fov_x_degrees_) / size.width;  // its width at distance 1
  Vec3 const direction((x - size.width / 2.0) * pixel, (size.height / 2.0 - y) * pixel, -1);
  Vec3 const center = world_from_camera_.point(Vec3(0)), ahead = world_from_camera_.vector(direction);
  if (lens_.aperture == 0) return {center, unit_vector(ahead)};
  Vec3 const right = unit_vector(world_from_camera_.vector({1, 0, 0}));
  Vec3 const up = unit_vector(world_from_camera_.vector({0, 1, 0}));
  Vec3 const from_center = 0.5 * lens_.aperture * (lens_x * right + lens_y * up);
  double const focus = lens_.focus_distance / glm::length(world_from_camera_.vector({0, 0, -1}));
  return {center + from_center, unit_vector(focus * ahead - from_center)};
}

std::ostream& operator<<(std::ostream& out, Camera const& camera) {
  Vec3 const eye = camera.world_from_camera().point(Vec3(0));
  Vec3 const direction = unit_vector(camera.world_from_camera().vector(Vec3(0, 0, -1)));
  out << fmt::format("camera '{}': fov {} degrees, at {}, looking along {}", camera.name(), camera.fov_x_degrees(),
                     format_numbers(eye), format_numbers(direction));
  if (camera.resolution()) out << fmt::format(", {} x {}", camera.resolution()->width, camera.resolution()->height);
  if (camera.lens().aperture > 0) {
    out << fmt::format(", aperture {}, focus {}", camera.lens().aperture, camera.lens().focus_distance);
  }
  return out;
}

}  // namespace lichtraum
