#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <limits>
#include <ranges>
#include <vector>

#include "core/elementary.hpp"
#include "core/float3.hpp"
#include "lichtraum/camera.hpp"

// What a camera keeps in pictures of any proportions, and from where it sees all of a box.

namespace lichtraum {

namespace {

bool is_across(CameraFit::Side side, Resolution const& size) {
  return side == CameraFit::Side::width || (side == CameraFit::Side::longer && size.width >= size.height);
}

double fov_x_of(CameraFit const& fit, Resolution const& size) {
  if (is_across(fit.side, size)) return fit.fov_degrees;
  double const fov =
      glm::degrees(2 * atan2_of(0.5 * Camera("", fit.fov_degrees).width_at(1) * size.width, size.height));
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

/// From where it sees all of the corners and has the center in the middle of its picture, half of which is that wide
/// and high at distance 1. Places are in the corners' frame.
Vec3 place_looking_at_center(std::vector<Vec3> const& corners, double half_width, double half_height) {
  return {0, 0, greatest_of(corners, [&](Vec3 const& p) {
            return p.z + std::max(std::abs(p.x) / half_width, std::abs(p.y) / half_height);
          })};
}

/// From where it has the image of all of them there.
Vec3 place_with_image_in_middle(std::vector<Vec3> const& corners, double half_width, double half_height) {
  double const distance =
      std::max(distance_between_edges(corners, 0, half_width), distance_between_edges(corners, 1, half_height));
  return {middle_of_image(corners, 0, distance), middle_of_image(corners, 1, distance), distance};
}

}  // namespace

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
  Vec3 place(0);
  if (is_parallel) {
    double const half =
        greatest_of(corners, [&](Vec3 const& p) { return std::max(std::abs(p.x), std::abs(p.y) * aspect_ratio); });
    if (half > 0) result.width_ = 2 * margin * half;
    // As far away as all of it is large: nothing of it lies behind the camera.
    place.z = 2 * greatest_of(corners, [](Vec3 const& p) { return glm::length(p); });
  } else {
    double const half_width = 0.5 * result.width_at(1) / margin;
    double const half_height = half_width / aspect_ratio;
    place = framed.look_at ? place_looking_at_center(corners, half_width, half_height)
                           : place_with_image_in_middle(corners, half_width, half_height);
  }
  if (!(place.z > 0)) place = {0, 0, 1};  // of a single point
  Vec3 const position = framed.center() + rotation.vector(place);
  // From within, what is so large that numbers do not reach as far as it is seen from.
  result.set_world_from_camera(Transform::translation(is_finite(position) ? position : framed.center()) * rotation);
  return result;
}

}  // namespace lichtraum
