#include "compile/light_table.hpp"

#include <glm/trigonometric.hpp>

#include "core/elementary.hpp"
#include "scene/device_conversion.hpp"

namespace lichtraum {
namespace {

/// Whether rays from the point resolve the scene: their t has 24 bits for all of the distance.
bool is_near(Vec3 const& point, DeviceBounds const& bounds) {
  constexpr double max_distance = 16;  // in diagonals of the scene
  if (bounds.is_empty()) return false;
  Vec3 const min(bounds.min), max(bounds.max);
  return glm::distance(point, 0.5 * (min + max)) <= max_distance * glm::distance(min, max);
}

device::PunctualLight punctual_light(Light const& light, DeviceBounds const& world_bounds) {
  device::PunctualLight out{};
  out.ld = device_float4(light.ld());
  if (light.kind() == LightKind::directional) {
    out.kind = LIGHT_DIRECTIONAL;
    out.position = device_float4(-light.direction());
    return out;
  }
  out.kind = light.falls_off() ? LIGHT_FALLS_OFF : LIGHT_CONSTANT;
  out.position = device_float4(light.position(), is_near(light.position(), world_bounds) ? 1 : 0);
  out.inverse_range = float(1 / light.range());
  out.cone_offset = 1;
  if (light.kind() == LightKind::spot) {
    double const inner = cos_of(glm::radians(light.cone().inner_degrees));
    double const outer = cos_of(glm::radians(light.cone().outer_degrees));
    double const scale = 1 / std::max(inner - outer, 0.001);
    out.direction = device_float4(light.direction());
    out.cone_scale = float(scale);
    out.cone_offset = float(-outer * scale);
  }
  return out;
}

}  // namespace

BigVector<device::PunctualLight> make_light_table(std::vector<Light> const& lights, DeviceBounds const& world_bounds) {
  BigVector<device::PunctualLight> table;
  for (Light const& light : lights) {
    if (light.kind() != LightKind::ambient) table.push_back(punctual_light(light, world_bounds));
  }
  return table;
}

}  // namespace lichtraum
