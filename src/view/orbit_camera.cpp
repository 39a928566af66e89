#include "view/orbit_camera.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include "lichtraum/orbit.hpp"
#include "view/values_as_esdf.hpp"

namespace lichtraum::view {
namespace {

Vec3 position_of(Camera const& camera) { return camera.world_from_camera().point(Vec3(0)); }
Vec3 forward_of(Camera const& camera) { return glm::normalize(camera.world_from_camera().vector({0, 0, -1})); }
Vec3 right_of(Camera const& camera) { return glm::normalize(camera.world_from_camera().vector({1, 0, 0})); }
Vec3 up_of(Camera const& camera) { return glm::normalize(camera.world_from_camera().vector({0, 1, 0})); }

/// Of a length across the camera's own frame, in the world.
double unit_length_of(Camera const& camera) { return glm::length(camera.world_from_camera().vector({1, 0, 0})); }

Transform about(Vec3 const& point, double degrees, Vec3 const& axis) {
  return Transform::translation(point) * Transform::rotation(degrees, axis) * Transform::translation(-point);
}

}  // namespace

OrbitCamera::OrbitCamera(Camera camera, Vec3 const& center, Resolution const& made_for, Vec3 const& up, double radius)
    : camera_(std::move(camera)),
      fov_x_degrees_(camera_.fov_x_degrees()),
      width_(camera_.width()),
      made_for_(made_for),
      up_(orbit_rotation({}, up).vector({0, 1, 0})) {
  Vec3 const eye = position_of(camera_);
  double const ahead = glm::dot(center - eye, forward_of(camera_));
  // What lies beside or behind is as far ahead as it is away.
  double const wanted = ahead > 0 ? ahead : glm::distance(center, eye);
  // So far that shares of it, by which the camera zooms and pans, are seen.
  double const least = radius > 0 ? 0.25 * radius : 1e-3;
  double const distance = std::max(wanted, least);
  pivot_ = eye + distance * forward_of(camera_);
  // A model in the middle of its picture has the middle of its box a few hundredths of the width beside it.
  constexpr double little = 0.1;
  if (ahead >= least && glm::distance(center, pivot_) <= little * width_at(distance)) pivot_ = center;
}

double OrbitCamera::width_at(double distance) const {
  return camera_.is_orthographic() ? camera_.width() * unit_length_of(camera_) : camera_.width_at(distance);
}

double OrbitCamera::distance() const { return glm::distance(position_of(camera_), pivot_); }

void OrbitCamera::apply(Transform const& world_from_world) {
  camera_.set_world_from_camera(world_from_world * camera_.world_from_camera());
}

void OrbitCamera::fit_to(Resolution const& size) {
  using Length = long long;
  bool const is_wider = Length(size.width) * made_for_.height > Length(made_for_.width) * size.height;
  CameraFit fit{CameraFit::Side::width, fov_x_degrees_, {}, width_};
  if (is_wider) {
    double const height_share = double(made_for_.height) / made_for_.width;
    double const half_height = std::tan(glm::radians(0.5 * fov_x_degrees_)) * height_share;
    fit = {CameraFit::Side::height, 2 * glm::degrees(std::atan(half_height)), {}, width_ * height_share};
  }
  camera_.set_fit(fit);
  camera_ = camera_.fitted(size);
}

void OrbitCamera::orbit(double right_degrees, double up_degrees) {
  constexpr double highest_degrees = 89;
  double const elevation = glm::degrees(std::asin(std::clamp(-glm::dot(forward_of(camera_), up_), -1.0, 1.0)));
  double const wanted =
      std::clamp(elevation + up_degrees, std::min(-highest_degrees, elevation), std::max(highest_degrees, elevation));
  // The axis is horizontal whatever the camera's roll: then the elevation changes by just this.
  Vec3 const across = glm::cross(forward_of(camera_), up_);
  if (glm::length(across) > 1e-6) apply(about(pivot_, elevation - wanted, across));
  apply(about(pivot_, right_degrees, up_));
}

void OrbitCamera::pan(double right, double up) {
  Vec3 const offset = width_at(distance()) * (right * right_of(camera_) + up * up_of(camera_));
  apply(Transform::translation(offset));
  pivot_ += offset;
}

void OrbitCamera::zoom(double factor) {
  apply(Transform::translation((1 - factor) * (pivot_ - position_of(camera_))));
  if (camera_.is_orthographic()) set_width(factor * camera_.width());
}

void OrbitCamera::set_width(double width) {
  double const seen = std::clamp(width, 1e-30, 1e30);
  width_ *= seen / camera_.width();
  camera_.set_fit({CameraFit::Side::width, 0, {}, seen});
  camera_ = camera_.fitted(made_for_);
}

void OrbitCamera::frame(Vec3 const& center, double radius, Resolution const& size) {
  double const ball = std::max(radius, 1e-6);
  double distance = 2 * ball;
  if (camera_.is_orthographic()) {
    set_width(2 * ball * std::max(1.0, double(size.width) / size.height) / unit_length_of(camera_));
  } else {
    double const half_width = std::tan(glm::radians(0.5 * camera_.fov_x_degrees()));
    double const half_height = half_width * size.height / size.width;
    distance = ball / std::sin(std::atan(std::min(half_width, half_height)));
  }
  apply(Transform::translation(center - distance * forward_of(camera_) - position_of(camera_)));
  pivot_ = center;
}

std::string camera_as_esdf(Camera const& camera, Resolution const& size) {
  Vec3 const back = -forward_of(camera);
  Vec3 const right = glm::normalize(glm::cross(up_of(camera), back));
  glm::dquat const rotation = glm::normalize(glm::quat_cast(Mat3(right, glm::cross(back, right), back)));
  Vec3 const axis(rotation.x, rotation.y, rotation.z);
  double const sine = glm::length(axis);
  Vec3 const eye = position_of(camera);
  std::string const name = camera.name().empty() ? "view" : word_of(camera.name());
  Lens const& lens = camera.lens();
  std::string keys = lens.aperture > 0 ? fmt::format(" aperture={} focus={}", lens.aperture, lens.focus_distance) : "";
  constexpr double any_angle = 45;  // which an orthographic camera has no use for
  double const fov_x_degrees = camera.is_orthographic() ? any_angle : camera.fov_x_degrees();
  // How long rays' directions are plays no role, so that along the view the scale is 1.
  Mat3 const axes(camera.world_from_camera().matrix());
  if (camera.is_orthographic()) keys += fmt::format(" orthographic={}", camera.width() * glm::length(axes[2]));
  std::string text = fmt::format("define camera {} {} {} {}{}\n", name, fov_x_degrees, size.width, size.height, keys);
  double const mirrored = glm::determinant(axes) < 0 ? -1 : 1;
  Vec3 const scale(mirrored * glm::length(axes[0]) / glm::length(axes[2]), glm::length(axes[1]) / glm::length(axes[2]),
                   1);
  if (glm::distance(scale, Vec3(1)) > 1e-12) {
    text += fmt::format("transform {} scale {} {} {}\n", name, scale.x, scale.y, scale.z);
  }
  if (sine > 1e-12) {
    double const degrees = glm::degrees(2 * std::atan2(sine, rotation.w));
    text +=
        fmt::format("transform {} rotate {} {} {} {}\n", name, degrees, axis.x / sine, axis.y / sine, axis.z / sine);
  }
  return text + fmt::format("transform {} translate {} {} {}\n", name, eye.x, eye.y, eye.z);
}

}  // namespace lichtraum::view
