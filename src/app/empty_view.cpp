#include "app/empty_view.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace lichtraum::app {
namespace {

double degrees(double radians) { return radians * 180 / std::numbers::pi; }

std::string turn(double angle_degrees, char const* positive, char const* negative) {
  return fmt::format("{:.0f} degrees {}", std::abs(angle_degrees), angle_degrees > 0 ? positive : negative);
}

}  // namespace

std::string describe_direction(Camera const& camera, Bounds const& bounds) {
  if (bounds.is_empty()) return "the scene draws no shapes, or nothing but planes";
  Vec3 const center = camera.world_from_camera().inverse().point(bounds.center());
  double const distance = glm::length(center);
  double const radius = 0.5 * glm::length(camera.world_from_camera().inverse().vector(bounds.max - bounds.min));
  if (distance < 0.01 * radius) return "the camera is in the middle of the scene, and looks past its shapes";

  double const right = degrees(std::atan2(center.x, -center.z));
  double const up = degrees(std::atan2(center.y, std::hypot(center.x, center.z)));
  bool const is_turned = std::abs(right) >= 1;
  bool const is_tilted = std::abs(up) >= 1;
  if (!is_turned && !is_tilted) {
    return fmt::format(
        "the scene is straight ahead, {:.3g} away and {:.3g} wide: its shapes are too small to be hit, "
        "or lie off-centre",
        distance, 2 * radius);
  }
  std::string where;
  if (is_turned) where = turn(right, "to the right of", "to the left of");
  if (is_tilted) where += (is_turned ? " and " : "") + turn(up, "above", "below");
  return fmt::format("the scene is {} the view{}", where, std::abs(right) > 90 ? ", behind the camera" : "");
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
