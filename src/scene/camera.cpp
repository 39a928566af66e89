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

void check_width(double width) {
  if (!(width > 0 && std::isfinite(width))) {
    throw std::invalid_argument("an orthographic camera's width must be above 0 and finite");
  }
}

bool is_across(CameraFit::Side side, Resolution const& size) {
  return side == CameraFit::Side::width || (side == CameraFit::Side::longer && size.width >= size.height);
}

double fov_x_of(CameraFit const& fit, Resolution const& size) {
  if (is_across(fit.side, size)) return fit.fov_degrees;
  double const fov = glm::degrees(2 * atan2_of(half_width_of(fit.fov_degrees) * size.width, size.height));
  return std::clamp(fov, 1e-12, std::nextafter(180.0, 0.0));  // roundings must not make it none
}

constexpr double margin = 1.03;  // little, as hardly anything fills its box

/// The greatest that `of_corner` gives for a corner of the box as the camera sees it from the center, wherever it turns
/// to: x to the right, y up, z towards the camera. At least 0, which is what a point has.
template <typename Function>
double greatest_of_corners(CameraFit::Framed const& framed, Transform const& rotation, Function const& of_corner) {
  bool const turns = framed.turn_axis != Vec3(0);
  int const steps = turns ? 120 : 1;  // between which a corner comes no nearer than by a thousandth
  double greatest = 0;
  for (int i = 0; i < steps; ++i) {
    Transform const turned = turns ? Transform::rotation(i * 360.0 / steps, framed.turn_axis) * rotation : rotation;
    for (int corner = 0; corner < 8; ++corner) {
      greatest = std::max(greatest, of_corner(turned.inverse().vector(corner_of(framed.box, corner) - framed.center)));
    }
  }
  return greatest;
}

/// How far from the center a camera must stand to see all of the box.
double framing_distance(CameraFit::Framed const& framed, Transform const& rotation, double half_width,
                        double half_height) {
  return greatest_of_corners(framed, rotation, [&](Vec3 const& p) {
    return p.z + std::max(margin * std::abs(p.x) / half_width, margin * std::abs(p.y) / half_height);
  });
}

/// How wide an orthographic camera's picture must be to show all of the box. `aspect_ratio`: width over height.
double framing_width(CameraFit::Framed const& framed, Transform const& rotation, double aspect_ratio) {
  return 2 * margin * greatest_of_corners(framed, rotation, [&](Vec3 const& p) {
           return std::max(std::abs(p.x), std::abs(p.y) * aspect_ratio);
         });
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

Camera Camera::fitted(Resolution const& size) const {
  if (!fit_) return *this;
  bool const is_parallel = fit_->extent > 0;
  double const aspect_ratio = double(size.width) / size.height;
  double const extent_x = fit_->extent * (is_across(fit_->side, size) ? 1 : aspect_ratio);
  Camera result = is_parallel ? orthographic(name_, extent_x, world_from_camera_, resolution_)
                              : Camera(name_, fov_x_of(*fit_, size), world_from_camera_, resolution_);
  result.lens_ = lens_;
  if (!fit_->framed) return result;
  CameraFit::Framed const& framed = *fit_->framed;
  Transform const rotation = Transform::translation(-world_from_camera_.point(Vec3(0))) * world_from_camera_;
  double needed = 0;
  if (is_parallel) {
    double const width = framing_width(framed, rotation, aspect_ratio);
    if (width > 0) result.width_ = width;
    // As far away as all of it is large: nothing of it lies behind the camera.
    needed = 2 * greatest_of_corners(framed, rotation, [](Vec3 const& p) { return glm::length(p); });
  } else {
    double const half_width = half_width_of(result.fov_x_degrees());
    needed = framing_distance(framed, rotation, half_width, half_width * size.height / size.width);
  }
  double const distance = needed > 0 ? needed : 1;  // of a single point
  result.set_world_from_camera(Transform::translation(framed.center + distance * rotation.vector(Vec3(0, 0, 1))) *
                               rotation);
  return result;
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
