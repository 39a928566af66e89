#include "lichtraum/light.hpp"

#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>
#include <ostream>
#include <stdexcept>

#include "core/elementary.hpp"
#include "core/format_numbers.hpp"
#include "scene/unit_vector.hpp"

namespace lichtraum {
namespace {

Vec3 checked_direction(Vec3 const& direction) {
  if (direction == Vec3(0)) throw std::invalid_argument("a light's direction must not be zero");
  return unit_vector(direction);
}

}  // namespace

Light Light::ambient(std::string name, Rgb const& la) {
  Light light;
  light.name_ = std::move(name);
  light.kind_ = LightKind::ambient;
  light.la_ = la;
  light.ld_ = Rgb(0);
  return light;
}

Light Light::point(std::string name, Vec3 const& position, Rgb const& ld, Rgb const& la) {
  Light light;
  light.name_ = std::move(name);
  light.position_ = position;
  light.la_ = la;
  light.ld_ = ld;
  return light;
}

Light Light::falling_off(std::string name, Vec3 const& position, Rgb const& intensity, double range) {
  if (!(range > 0)) throw std::invalid_argument("a light's range must be positive");
  Light light = point(std::move(name), position, intensity);
  light.falls_off_ = true;
  light.range_ = range;
  return light;
}

Light Light::spot(std::string name, Vec3 const& position, Vec3 const& direction, Rgb const& intensity,
                  SpotCone const& cone, double range) {
  bool const is_cone = cone.inner_degrees >= 0 && cone.inner_degrees < cone.outer_degrees && cone.outer_degrees <= 90;
  if (!is_cone) throw std::invalid_argument("a spot light's angles must be 0 <= inner < outer <= 90 degrees");
  Light light = falling_off(std::move(name), position, intensity, range);
  light.kind_ = LightKind::spot;
  light.direction_ = checked_direction(direction);
  light.cone_ = cone;
  return light;
}

Light Light::directional(std::string name, Vec3 const& direction, Rgb const& ld) {
  Light light;
  light.name_ = std::move(name);
  light.kind_ = LightKind::directional;
  light.direction_ = checked_direction(direction);
  light.ld_ = ld;
  return light;
}

// KHR_lights_punctual, "Range Property" and "Inner and Outer Cone Angles".
Rgb Light::arriving_at(Vec3 const& point) const {
  if (!falls_off_) return ld_;
  Vec3 const way = point - position_;
  double const distance = glm::length(way);
  if (distance == 0) return Rgb(0);
  double const share = distance / range_;
  double const window = std::clamp(1 - share * share * share * share, 0.0, 1.0);
  double cone = 1;
  if (kind_ == LightKind::spot) {
    double const inner = cos_of(glm::radians(cone_.inner_degrees));
    double const outer = cos_of(glm::radians(cone_.outer_degrees));
    double const cosine = glm::dot(direction_, way) / distance;
    double const inside = std::clamp((cosine - outer) / std::max(inner - outer, 0.001), 0.0, 1.0);
    cone = inside * inside;
  }
  return ld_ * (window * cone / (distance * distance));
}

std::string_view name_of(LightKind kind) {
  switch (kind) {
    case LightKind::ambient:
      return "ambient";
    case LightKind::spot:
      return "spot";
    case LightKind::directional:
      return "directional";
    default:
      return "point";
  }
}

std::ostream& operator<<(std::ostream& out, Light const& light) {
  out << fmt::format("{} light '{}':", name_of(light.kind()), light.name());
  if (light.has_position()) out << fmt::format(" position {},", format_numbers(light.position()));
  if (light.kind() == LightKind::spot || light.kind() == LightKind::directional) {
    out << fmt::format(" direction {},", format_numbers(light.direction()));
  }
  if (light.kind() == LightKind::spot) {
    out << fmt::format(" cone {} {},", light.cone().inner_degrees, light.cone().outer_degrees);
  }
  if (light.kind() == LightKind::ambient) return out << fmt::format(" la {}", format_numbers(light.la()));
  out << fmt::format(" la {}, ld {}", format_numbers(light.la()), format_numbers(light.ld()));
  if (light.falls_off()) out << fmt::format(", falls off, range {}", light.range());
  return out;
}

}  // namespace lichtraum
