#include "view/window/sliders.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <iterator>

#include "view/scene_values.hpp"

namespace lichtraum::view {
namespace {

bool edit_number(char const* label, double& value, double low, double high, ImGuiSliderFlags flags = 0) {
  auto number = float(value);
  if (!ImGui::SliderFloat(label, &number, float(low), float(high), "%.3g", flags | ImGuiSliderFlags_AlwaysClamp)) {
    return false;
  }
  value = double(number);
  return true;
}

/// Numbers can be typed as well, of any size.
bool are_finite(float const (&numbers)[3]) {
  return std::all_of(std::begin(numbers), std::end(numbers), [](float number) { return std::isfinite(number); });
}

bool edit_color(char const* label, Rgb& color) {
  float channels[] = {float(color.r), float(color.g), float(color.b)};
  if (!ImGui::ColorEdit3(label, channels, ImGuiColorEditFlags_Float | ImGuiColorEditFlags_HDR)) return false;
  if (!are_finite(channels)) return false;
  for (int c = 0; c < 3; ++c) color[c] = std::max(0.0, double(channels[c]));
  return true;
}

/// A colour, and how bright it is in its brightest channel.
bool edit_light_color(Rgb& color, Rgb const& original) {
  auto const brightest = [](Rgb const& c) { return std::max({c.r, c.g, c.b}); };
  double brightness = brightest(color);
  Rgb hue = brightness > 0 ? color / brightness : brightest(original) > 0 ? original / brightest(original) : Rgb(1);
  double const range = brightest(original) > 0 ? 4 * brightest(original) : 4;
  bool const has_changed = edit_number("brightness", brightness, 0, range) | edit_color("colour", hue);
  if (has_changed) color = brightness * hue;
  return has_changed;
}

bool edit_position(Vec3& position, double scene_size) {
  float p[] = {float(position.x), float(position.y), float(position.z)};
  if (!ImGui::DragFloat3("position", p, float(0.005 * scene_size), 0, 0, "%.3g")) return false;
  if (!are_finite(p)) return false;
  position = {double(p[0]), double(p[1]), double(p[2])};
  return true;
}

/// As an azimuth, from the -z axis towards +x, and an elevation.
bool edit_direction(Vec3& direction) {
  double azimuth = glm::degrees(std::atan2(direction.x, -direction.z));
  double elevation = glm::degrees(std::asin(std::clamp(direction.y, -1.0, 1.0)));
  bool const has_changed =
      edit_number("azimuth", azimuth, -180, 180) | edit_number("elevation", elevation, -89.9, 89.9);
  if (!has_changed) return false;
  double const a = glm::radians(azimuth), e = glm::radians(elevation);
  direction = {std::cos(e) * std::sin(a), std::sin(e), -std::cos(e) * std::cos(a)};
  return true;
}

bool edit_cone(SpotCone& cone) {
  bool const has_changed =
      edit_number("inner angle", cone.inner_degrees, 0, 89) | edit_number("outer angle", cone.outer_degrees, 0.5, 90);
  cone.inner_degrees = std::min(cone.inner_degrees, cone.outer_degrees - 0.5);
  return has_changed;
}

bool edit_phong(Material& material) {
  Rgb ka = material.ka(), kd = material.kd(), ks = material.ks(), emission = material.emission();
  double m = material.m(), reflect = material.reflect(), transmit = material.transmit(), ior = material.ior();
  bool has_changed = edit_color("ka", ka) | edit_color("kd", kd) | edit_color("ks", ks) |
                     edit_number("m", m, 0, 1000, ImGuiSliderFlags_Logarithmic);
  if (edit_number("reflect", reflect, 0, 1)) {
    transmit = std::min(transmit, 1 - reflect);
    has_changed = true;
  }
  if (edit_number("transmit", transmit, 0, 1)) {
    reflect = std::min(reflect, 1 - transmit);
    has_changed = true;
  }
  has_changed |= edit_number("ior", ior, 1, 3);
  has_changed |= edit_color("emission", emission);
  if (!has_changed) return false;
  Material changed(material.name(), ka, kd, ks, m);
  changed.set_mirror_and_glass(reflect, transmit, ior);
  changed.set_emission(emission);
  changed.set_pbr(material.pbr());
  material = changed;
  return true;
}

bool edit_pbr(Material& material) {
  PbrMaterial pbr = *material.pbr();
  Rgb color(pbr.base_color);
  bool has_changed = edit_color("base colour", color);
  pbr.base_color = {color, pbr.base_color.a};
  if (pbr.alpha_mode == AlphaMode::blend) has_changed |= edit_number("alpha", pbr.base_color.a, 0, 1);
  if (pbr.alpha_mode == AlphaMode::mask) has_changed |= edit_number("alpha cutoff", pbr.alpha_cutoff, 0, 1);
  has_changed |= edit_number("metallic", pbr.metallic, 0, 1);
  has_changed |= edit_number("roughness", pbr.roughness, 0, 1);
  has_changed |= edit_color("emissive", pbr.emissive);
  has_changed |= edit_number("transmission", pbr.transmission, 0, 1);
  has_changed |= edit_number("ior", pbr.ior, 1, 3);
  if (pbr.normal_texture) has_changed |= edit_number("normal scale", pbr.normal_scale, 0, 4);
  if (has_changed) material = phong_from_pbr(material.name(), std::make_shared<PbrMaterial const>(pbr));
  return has_changed;
}

}  // namespace

bool edit_light(Light& light, Light const& original, double scene_size) {
  Rgb la = light.la(), ld = light.ld();
  Vec3 position = light.position(), direction = light.direction();
  SpotCone cone = light.cone();
  bool has_changed = false;
  if (light.kind() == LightKind::ambient) {
    if (!edit_light_color(la, original.la())) return false;
    light = Light::ambient(light.name(), la);
    return true;
  }
  has_changed |= edit_light_color(ld, original.ld());
  if (light.has_position()) has_changed |= edit_position(position, scene_size);
  if (light.kind() != LightKind::point) has_changed |= edit_direction(direction);
  if (light.kind() == LightKind::spot) has_changed |= edit_cone(cone);
  if (!has_changed) return false;
  if (light.kind() == LightKind::directional) {
    light = Light::directional(light.name(), direction, ld);
  } else if (light.kind() == LightKind::spot) {
    light = Light::spot(light.name(), position, direction, ld, cone, light.range());
  } else if (light.falls_off()) {
    light = Light::falling_off(light.name(), position, ld, light.range());
  } else {
    light = Light::point(light.name(), position, ld, la);
  }
  return true;
}

bool edit_material(Material& material) {
  return is_physically_based(material) ? edit_pbr(material) : edit_phong(material);
}

}  // namespace lichtraum::view
