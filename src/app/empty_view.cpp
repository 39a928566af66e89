#include "app/empty_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace lichtraum::app {
namespace {

double degrees(double radians) { return radians * 180 / std::numbers::pi; }

/// "30 degrees to the right of and 10 degrees above": what hardly counts beside the other is left out.
std::string aside(Camera const& camera, Vec3 const& center) {
  constexpr double steep = 80;  // degrees; near the vertical, left and right mean nothing
  double right = center.x, up = center.y;
  if (!camera.is_orthographic()) {
    up = degrees(std::atan2(center.y, std::hypot(center.x, center.z)));
    right = std::abs(up) < steep ? degrees(std::atan2(center.x, -center.z)) : 0;
  }
  double const least = 0.02 * std::max(std::abs(right), std::abs(up));
  auto const part = [&](double amount, char const* positive, char const* negative) {
    if (std::abs(amount) <= least) return std::string();
    return fmt::format("{:.3g} {} {}", std::abs(amount), camera.is_orthographic() ? "units" : "degrees",
                       amount > 0 ? positive : negative);
  };
  std::string const across = part(right, "to the right of", "to the left of");
  std::string const along = part(up, "above", "below");
  return across + (across.empty() || along.empty() ? "" : " and ") + along;
}

std::string describe_behind(Camera const& camera) {
  Transform const& world_from_camera = camera.world_from_camera();
  if (world_from_camera.matrix() == Mat4(1))
    return "the scene is behind the camera, which looks along -z: what lies before it has a negative z";
  Vec3 const eye = world_from_camera.point(Vec3(0)), ahead = glm::normalize(world_from_camera.vector(Vec3(0, 0, -1)));
  return fmt::format(
      "the scene is behind the camera, which is at {:.3g} {:.3g} {:.3g} and looks along {:.3g} {:.3g} {:.3g}", eye.x,
      eye.y, eye.z, ahead.x, ahead.y, ahead.z);
}

/// Of a scene whose middle, so far ahead, is in view.
std::string describe_ahead(double depth, double diameter, double pixel) {
  constexpr double few_pixels = 4;
  return fmt::format("the scene is in view, {:.3g} away and {:.3g} wide: its shapes {}", depth, diameter,
                     diameter < few_pixels * pixel
                         ? "are too small for the pixels"
                         : "lie beside what the camera sees, or are invisible (alpha or d of 0)");
}

}  // namespace

std::string describe_direction(Camera const& camera, Resolution const& size, Bounds const& bounds) {
  if (bounds.is_empty()) return "the scene draws no shapes, or nothing but planes";
  Transform const camera_from_world = camera.world_from_camera().inverse();
  Vec3 const center = camera_from_world.point(bounds.center());
  double const diameter = glm::length(camera_from_world.vector(bounds.max - bounds.min));
  if (glm::length(center) < 0.005 * diameter)
    return "the camera is in the middle of the scene, and looks past its shapes";

  double const depth = -center.z;
  double const pixel = depth > 0 ? camera.width_at(depth) / size.width : 0;
  bool const is_in_view =
      std::abs(center.x) < 0.5 * size.width * pixel && std::abs(center.y) < 0.5 * size.height * pixel;
  if (is_in_view) return describe_ahead(depth, diameter, pixel);
  if (depth < 0 && std::hypot(center.x, center.y) < -depth) return describe_behind(camera);
  return fmt::format("the scene is {} where the camera looks", aside(camera, center));
}

std::vector<Convention> other_conventions(EsdfDialect const& dialect) {
  bool const is_right = dialect.rotation == RotationSense::right;
  bool const is_parent = dialect.transform_order == TransformOrder::parent;
  std::string const rotation = is_right ? "--rotation left" : "--rotation right";
  std::string const order = is_parent ? "--transform-order local" : "--transform-order parent";
  EsdfDialect rotated = dialect;
  rotated.rotation = is_right ? RotationSense::left : RotationSense::right;
  EsdfDialect reordered = dialect;
  reordered.transform_order = is_parent ? TransformOrder::local : TransformOrder::parent;
  EsdfDialect both = rotated;
  both.transform_order = reordered.transform_order;
  return {{rotated, rotation}, {reordered, order}, {both, rotation + " " + order}};
}

}  // namespace lichtraum::app
