#include "lichtraum/camera.hpp"

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

void check_width(double width) {
  if (!(width > 0 && std::isfinite(width))) {
    throw std::invalid_argument("an orthographic camera's width must be above 0 and finite");
  }
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

Camera Camera::orthographic(std::string name, double width, Transform const& world_from_camera,
                            std::optional<Resolution> resolution) {
  check_width(width);
  Camera camera;
  camera.name_ = std::move(name);
  camera.fov_x_degrees_ = 0;
  camera.width_ = width;
  camera.resolution_ = resolution;
  camera.world_from_camera_ = world_from_camera;
  return camera;
}

double Camera::width_at(double distance) const {
  return is_orthographic() ? width_ : 2 * distance * half_width_of(fov_x_degrees_);
}

void Camera::set_fit(CameraFit const& fit) {
  if (fit.extent == 0) {
    check_fov(fit.fov_degrees);
  } else {
    check_width(fit.extent);
  }
  fit_ = fit;
}

void Camera::set_lens(Lens const& lens) {
  bool const is_good = lens.aperture >= 0 && std::isfinite(lens.aperture) && lens.focus_distance > 0 &&
                       std::isfinite(lens.focus_distance);
  if (!is_good) throw std::invalid_argument("a lens needs an aperture of at least 0 and a focus distance above 0");
  lens_ = lens;
}

Ray Camera::generate_ray(double x, double y, Resolution const& size, double lens_x, double lens_y) const {
  double const pixel = width_at(1) / size.width;
  Vec3 const image((x - size.width / 2.0) * pixel, (size.height / 2.0 - y) * pixel, -1);
  Vec3 const plane_point = is_orthographic() ? Vec3(image.x, image.y, 0) : Vec3(0);
  Vec3 const center = world_from_camera_.point(plane_point);
  Vec3 const ahead = world_from_camera_.vector(image - plane_point);
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
  out << fmt::format("camera '{}': {}, at {}, looking along {}", camera.name(),
                     camera.is_orthographic() ? fmt::format("orthographic, {} wide", camera.width())
                                              : fmt::format("fov {} degrees", camera.fov_x_degrees()),
                     format_numbers(eye), format_numbers(direction));
  if (camera.resolution()) out << fmt::format(", {} x {}", camera.resolution()->width, camera.resolution()->height);
  if (camera.lens().aperture > 0) {
    out << fmt::format(", aperture {}, focus {}", camera.lens().aperture, camera.lens().focus_distance);
  }
  return out;
}

}  // namespace lichtraum
