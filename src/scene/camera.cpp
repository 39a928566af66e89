#include "lichtraum/camera.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <limits>
#include <ostream>
#include <ranges>
#include <stdexcept>
#include <vector>

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

constexpr double margin = 1.06;  // little, as hardly anything fills its box

/// The box's corners as the camera sees them from the center, wherever it turns to: x to the right, y up, z towards it.
std::vector<Vec3> corners_seen(CameraFit::Framed const& framed, Transform const& rotation) {
  bool const turns = framed.turn_axis != Vec3(0);
  int const steps = turns ? 120 : 1;  // between which a corner comes no nearer than by a thousandth
  std::vector<Vec3> corners;
  for (int i = 0; i < steps; ++i) {
    Transform const turned = turns ? Transform::rotation(i * 360.0 / steps, framed.turn_axis) * rotation : rotation;
    for (int corner = 0; corner < 8; ++corner) {
      corners.push_back(turned.inverse().vector(corner_of(framed.box, corner) - framed.center()));
    }
  }
  return corners;
}

/// The greatest that `of_corner` gives for one of them, at least 0, which is what a point has.
template <typename Function>
double greatest_of(std::vector<Vec3> const& corners, Function const& of_corner) {
  double greatest = 0;
  for (Vec3 const& corner : corners) greatest = std::max(greatest, of_corner(corner));
  return greatest;
}

/// How far a camera must stand from the center's plane to see all corners between two edges of its picture, `half` of
/// it from its middle at distance 1, where it may move along `axis`. The planes through the edges touch the corners
/// that are farthest out; where they meet is its place.
double distance_between_edges(std::vector<Vec3> const& corners, int axis, double half) {
  double farthest = -std::numeric_limits<double>::infinity(), nearest = -farthest;
  for (Vec3 const& p : corners) {
    farthest = std::max(farthest, p[axis] + half * p.z);
    nearest = std::min(nearest, p[axis] - half * p.z);
  }
  return (farthest - nearest) / (2 * half);
}

/// Where on `axis` the camera, that far from the center's plane, has the corners' image in the middle of its picture.
double middle_of_image(std::vector<Vec3> const& corners, int axis, double distance) {
  auto const [low, high] = std::ranges::minmax(corners, {}, [&](Vec3 const& p) { return p[axis]; });
  double lower = low[axis], upper = high[axis];
  for (int i = 0; i < 60; ++i) {
    double const middle = 0.5 * (lower + upper);
    double const above = greatest_of(corners, [&](Vec3 const& p) { return (p[axis] - middle) / (distance - p.z); });
    double const below = greatest_of(corners, [&](Vec3 const& p) { return (middle - p[axis]) / (distance - p.z); });
    (above > below ? lower : upper) = middle;
  }
  return 0.5 * (lower + upper);
}

/// Where a camera stands that sees all of the corners in a picture of that size at distance 1, in their frame.
Vec3 framing_place(std::vector<Vec3> const& corners, double width, double height, bool looks_at_center) {
  double const half_width = 0.5 * width / margin;
  double const half_height = 0.5 * height / margin;
  double const distance =
      looks_at_center
          ? greatest_of(
                corners,
                [&](Vec3 const& p) { return p.z + std::max(std::abs(p.x) / half_width, std::abs(p.y) / half_height); })
          : std::max(distance_between_edges(corners, 0, half_width), distance_between_edges(corners, 1, half_height));
  if (!(distance > 0)) return {0, 0, 1};  // of a single point
  if (looks_at_center) return {0, 0, distance};
  return {middle_of_image(corners, 0, distance), middle_of_image(corners, 1, distance), distance};
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
  std::vector<Vec3> const corners = corners_seen(framed, rotation);
  Vec3 place(0, 0, 1);
  if (is_parallel) {
    double const half =
        greatest_of(corners, [&](Vec3 const& p) { return std::max(std::abs(p.x), std::abs(p.y) * aspect_ratio); });
    if (half > 0) result.width_ = 2 * margin * half;
    // As far away as all of it is large: nothing of it lies behind the camera.
    double const radius = greatest_of(corners, [](Vec3 const& p) { return glm::length(p); });
    if (radius > 0) place.z = 2 * radius;
  } else {
    double const width = result.width_at(1);
    place = framing_place(corners, width, width * size.height / size.width, framed.look_at.has_value());
  }
  result.set_world_from_camera(Transform::translation(framed.center() + rotation.vector(place)) * rotation);
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
