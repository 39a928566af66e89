#include "lichtraum/light.hpp"

#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>
#include <ostream>
#include <stdexcept>

#include "core/elementary.hpp"
#include "core/format_numbers.hpp"
#include "scene/check_finite.hpp"
#include "scene/device_conversion.hpp"
#include "scene/device_light.hpp"
#include "scene/unit_vector.hpp"

namespace lichtraum {
namespace {

/// What may be wrong with the fields of any kind.
struct Check : LightFieldVisitor {
  void position(char const*, Vec3 const& position) const { check_finite(position, "a light's position"); }
  void brightness(char const*, Rgb const& color) const { check_finite(color, "a light's brightness"); }
  void ambient(char const*, Rgb const& color) const { check_finite(color, "a light's ambient term"); }
  void direction(char const*, Vec3& direction) const {
    if (!is_direction(direction)) throw std::invalid_argument("a light's direction must be finite and not zero");
    direction = unit_vector(direction);
  }
  void range(char const*, double range) const {
    if (!(range > 0)) throw std::invalid_argument("a light's range must be positive");
  }
  void cone(char const*, SpotCone const& cone) const {
    bool const is_cone = cone.inner_degrees >= 0 && cone.inner_degrees < cone.outer_degrees && cone.outer_degrees <= 90;
    if (!is_cone) throw std::invalid_argument("a spot light's angles must be 0 <= inner < outer <= 90 degrees");
  }
  void radius(char const*, double radius) const {
    if (!(radius >= 0) || !std::isfinite(radius))
      throw std::invalid_argument("a light's radius must be finite and at least 0");
  }
};

struct FindBrightness : LightFieldVisitor {
  Rgb found{0};
  void brightness(char const*, Rgb const& color) { found = color; }
};

struct Print {
  std::string text;
  void position(char const* name, Vec3 const& v) { triple(name, v); }
  void direction(char const* name, Vec3 const& v) { triple(name, v); }
  void brightness(char const* name, Rgb const& color) { triple(name, color); }
  void ambient(char const* name, Rgb const& color) {
    if (color != Rgb(0)) triple(name, color);
  }
  void flag(char const* name, bool holds) {
    if (holds) add(name);
  }
  void range(char const* name, double range) {
    if (std::isfinite(range)) add(fmt::format("{} {}", name, range));
  }
  void cone(char const* name, SpotCone const& cone) {
    add(fmt::format("{} {} {}", name, cone.inner_degrees, cone.outer_degrees));
  }
  void radius(char const* name, double radius) {
    if (radius > 0) add(fmt::format("{} {}", name, radius));
  }

 private:
  void triple(char const* name, Vec3 const& v) { add(fmt::format("{} {}", name, format_numbers(v))); }
  void add(std::string const& field) { text += (text.empty() ? "" : ", ") + field; }
};

// KHR_lights_punctual, "Range Property" and "Inner and Outer Cone Angles".

double falloff(double distance, double range) {
  double const share = distance / range;
  return std::clamp(1 - share * share * share * share, 0.0, 1.0) / (distance * distance);
}

/// Brightness in a cone: (cosine * scale + offset)^2, clamped to 0..1.
struct ConeFactors {
  double scale;
  double offset;
};
ConeFactors factors_of(SpotCone const& cone) {
  double const inner = cos_of(glm::radians(cone.inner_degrees));
  double const outer = cos_of(glm::radians(cone.outer_degrees));
  double const scale = 1 / std::max(inner - outer, 0.001);
  return {scale, -outer * scale};
}

// Of each kind: what arrives at a point, and the struct that the device reads.

Rgb arriving(AmbientLight const&, Vec3 const&) { return Rgb(0); }
Rgb arriving(PointLight const& light, Vec3 const& point) {
  if (!light.falls_off) return light.ld;
  double const distance = glm::distance(point, light.position);
  return distance == 0 ? Rgb(0) : light.ld * falloff(distance, light.range);
}
Rgb arriving(SpotLight const& light, Vec3 const& point) {
  Vec3 const way = point - light.position;
  double const distance = glm::length(way);
  if (distance == 0) return Rgb(0);
  ConeFactors const cone = factors_of(light.cone);
  double const cosine = glm::dot(light.direction, way) / distance;
  double const share = std::clamp(cosine * cone.scale + cone.offset, 0.0, 1.0);
  return light.ld * (falloff(distance, light.range) * share * share);
}
Rgb arriving(DirectionalLight const& light, Vec3 const&) { return light.ld; }

std::optional<device::PunctualLight> for_device(AmbientLight const&) { return std::nullopt; }
std::optional<device::PunctualLight> for_device(PointLight const& light) {
  device::PunctualLight out{};
  out.kind = light.falls_off ? LIGHT_FALLS_OFF : LIGHT_CONSTANT;
  store(light.position, out.position);
  store(light.ld, out.ld);
  out.inverse_range = float(1 / light.range);
  out.cone_offset = 1;
  out.radius = float(light.radius);
  return out;
}
std::optional<device::PunctualLight> for_device(SpotLight const& light) {
  device::PunctualLight out{};
  ConeFactors const cone = factors_of(light.cone);
  out.kind = LIGHT_FALLS_OFF;
  store(light.position, out.position);
  store(light.direction, out.direction);
  store(light.ld, out.ld);
  out.inverse_range = float(1 / light.range);
  out.cone_scale = float(cone.scale);
  out.cone_offset = float(cone.offset);
  return out;
}
std::optional<device::PunctualLight> for_device(DirectionalLight const& light) {
  device::PunctualLight out{};
  out.kind = LIGHT_DIRECTIONAL;
  store(light.direction, out.direction);
  store(light.ld, out.ld);
  return out;
}

}  // namespace

Light::Light(std::string name, Model model) : name_(std::move(name)), model_(std::move(model)) {
  std::visit(
      [](auto& light) {
        Check const check;
        for_each_field(light, check);
      },
      model_);
}

Light Light::ambient(std::string name, Rgb const& la) { return {std::move(name), AmbientLight{.la = la}}; }
Light Light::point(std::string name, Vec3 const& position, Rgb const& ld, Rgb const& la) {
  return {std::move(name), PointLight{.ld = ld, .la = la, .position = position}};
}
Light Light::falling_off(std::string name, Vec3 const& position, Rgb const& intensity, double range) {
  return {std::move(name), PointLight{.ld = intensity, .position = position, .falls_off = true, .range = range}};
}
Light Light::spot(std::string name, Vec3 const& position, Vec3 const& direction, Rgb const& intensity,
                  SpotCone const& cone, double range) {
  return {std::move(name),
          SpotLight{.ld = intensity, .position = position, .direction = direction, .cone = cone, .range = range}};
}
Light Light::directional(std::string name, Vec3 const& direction, Rgb const& ld) {
  return {std::move(name), DirectionalLight{.ld = ld, .direction = direction}};
}

std::string_view Light::kind() const {
  return std::visit([](auto const& light) { return light.kind; }, model_);
}

Rgb Light::la() const {
  return std::visit(
      [](auto const& light) {
        if constexpr (requires { light.la; }) {
          return light.la;
        } else {
          return Rgb(0);
        }
      },
      model_);
}

Rgb Light::brightness() const {
  FindBrightness brightness;
  std::visit([&](auto const& light) { for_each_field(light, brightness); }, model_);
  return brightness.found;
}

bool Light::casts_shadows() const { return !get<AmbientLight>(); }

Vec3 const* Light::position() const {
  return std::visit(
      [](auto const& light) -> Vec3 const* {
        if constexpr (requires { light.position; }) {
          return &light.position;
        } else {
          return nullptr;
        }
      },
      model_);
}

Vec3 Light::way_from(Vec3 const& point) const {
  if (Vec3 const* const place = position()) return *place - point;
  DirectionalLight const* const far = get<DirectionalLight>();
  return far ? -far->direction : Vec3(0);
}

Rgb Light::arriving_at(Vec3 const& point) const {
  return std::visit([&](auto const& light) { return arriving(light, point); }, model_);
}

std::optional<device::PunctualLight> device_light(Light const& light) {
  return std::visit([](auto const& model) { return for_device(model); }, light.model());
}

std::ostream& operator<<(std::ostream& out, Light const& light) {
  Print fields;
  std::visit([&](auto const& model) { for_each_field(model, fields); }, light.model());
  return out << fmt::format("{} light '{}': {}", light.kind(), light.name(), fields.text);
}

}  // namespace lichtraum
