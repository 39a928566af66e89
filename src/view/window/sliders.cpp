#include "view/window/sliders.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <initializer_list>
#include <iterator>
#include <string>

#include "core/largest_channel.hpp"
#include "view/edited_number.hpp"
#include "view/scene_values.hpp"
#include "view/window/graphics.hpp"

namespace lichtraum::view {

namespace {

/// Makes the next widget narrower, `least` at least, where its label would be cut off at its right.
void make_room_for(char const* label, float least) {
  float const beside = ImGui::GetStyle().ItemInnerSpacing.x + ImGui::CalcTextSize(label).x;
  float const usual = ImGui::CalcItemWidth(), left = ImGui::GetContentRegionAvail().x - beside;
  if (left < usual) ImGui::SetNextItemWidth(std::max(left, std::min(usual, least)));
}

/// The label of the last widget, where that is under the mouse and its label is cut off all the same.
void tell_cut_label(char const* label) {
  float const end = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
  if (ImGui::GetItemRectMax().x > end && ImGui::IsItemHovered()) ImGui::SetTooltip("%s", label);
}

}  // namespace

bool edit_number(char const* label, double& value, double low, double high, int flags) {
  auto number = float(value);
  make_room_for(label, scaled(40));
  bool const has_changed =
      ImGui::SliderFloat(label, &number, float(low), float(high), "%.3g", flags | ImGuiSliderFlags_AlwaysClamp);
  tell_cut_label(label);
  if (!has_changed) return false;
  value = edited_number(value, number);
  return true;
}

namespace {

/// Numbers can be typed as well, of any size.
bool are_finite(float const (&numbers)[3]) {
  return std::all_of(std::begin(numbers), std::end(numbers), [](float number) { return std::isfinite(number); });
}

bool edit_color(char const* label, Rgb& color) {
  float channels[] = {float(color.r), float(color.g), float(color.b)};
  make_room_for(label, scaled(120));
  bool const has_changed = ImGui::ColorEdit3(label, channels, ImGuiColorEditFlags_Float | ImGuiColorEditFlags_HDR);
  tell_cut_label(label);
  if (!has_changed || !are_finite(channels)) return false;
  for (int c = 0; c < 3; ++c) color[c] = edited_channel(color[c], channels[c]);
  return true;
}

/// Where `a || b` would leave out the second widget once the first has changed.
bool any_of(std::initializer_list<bool> has_changed) {
  return std::ranges::find(has_changed, true) != has_changed.end();
}

/// A colour, and how bright it is in its brightest channel.
bool edit_light_color(Rgb& color, Rgb const& original) {
  double brightness = largest_channel(color);
  double const original_brightness = largest_channel(original);
  Rgb const original_hue = original_brightness > 0 ? original / original_brightness : Rgb(1);
  Rgb hue = brightness > 0 ? color / brightness : original_hue;
  double const range = original_brightness > 0 ? 4 * original_brightness : 4;
  bool const has_changed = any_of({edit_number("brightness", brightness, 0, range), edit_color("colour", hue)});
  for (int c = 0; has_changed && c < 3; ++c) color[c] = edited_channel(color[c], float(brightness * hue[c]));
  return has_changed;
}

bool edit_position(Vec3& position, double scene_size) {
  float p[] = {float(position.x), float(position.y), float(position.z)};
  if (!ImGui::DragFloat3("position", p, float(0.005 * scene_size), 0, 0, "%.3g")) return false;
  if (!are_finite(p)) return false;
  for (int axis = 0; axis < 3; ++axis) position[axis] = edited_number(position[axis], p[axis]);
  return true;
}

/// As an azimuth, from the -z axis towards +x, and an elevation.
bool edit_direction(Vec3& direction) {
  double azimuth = glm::degrees(std::atan2(direction.x, -direction.z));
  double elevation = glm::degrees(std::asin(std::clamp(direction.y, -1.0, 1.0)));
  bool const has_changed =
      any_of({edit_number("azimuth", azimuth, -180, 180), edit_number("elevation", elevation, -89.9, 89.9)});
  if (!has_changed) return false;
  double const a = glm::radians(azimuth), e = glm::radians(elevation);
  direction = {std::cos(e) * std::sin(a), std::sin(e), -std::cos(e) * std::cos(a)};
  return true;
}

bool edit_cone(SpotCone& cone) {
  bool const has_changed = any_of(
      {edit_number("inner angle", cone.inner_degrees, 0, 89), edit_number("outer angle", cone.outer_degrees, 0.5, 90)});
  cone.inner_degrees = std::min(cone.inner_degrees, cone.outer_degrees - 0.5);
  return has_changed;
}

bool edit_field(char const* label, Rgb& color) { return edit_color(label, color); }
bool edit_field(char const* label, double& share) { return edit_number(label, share, 0, 1); }
bool edit_field(char const* label, double& number, double least, double most) {
  return edit_number(label, number, least, most, most >= 100 ? ImGuiSliderFlags_Logarithmic : 0);
}

/// Widgets for the fields of a light of any kind. The ambient term of a lamp, its range and whether it falls off at all
/// stay as they are.
struct EditLight : LightFieldVisitor {
  Rgb original_brightness;
  double scene_size;
  bool has_changed = false;
  EditLight(Rgb const& original, double size) : original_brightness(original), scene_size(size) {}
  void position(char const*, Vec3& position) { has_changed |= edit_position(position, scene_size); }
  void direction(char const*, Vec3& direction) { has_changed |= edit_direction(direction); }
  void brightness(char const*, Rgb& color) { has_changed |= edit_light_color(color, original_brightness); }
  void cone(char const*, SpotCone& cone) { has_changed |= edit_cone(cone); }
  void radius(char const*, double& radius) {  // without one, the scene may be drawn by whitted, which shows none
    if (radius > 0) has_changed |= edit_number("radius", radius, 0.001 * scene_size, 0.25 * scene_size);
  }
};

/// "base color" of base_color; "thickness min", for which there is room, of thickness_minimum.
std::string label_of(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  if (name.ends_with(" minimum") || name.ends_with(" maximum")) name.resize(name.rfind("imum"));
  return name;
}

bool edit(PhongModel& model) {
  PhongModel const before = model;
  bool has_changed = false;
#define LICHTRAUM_COLOR(name, initial) has_changed |= edit_field(#name, model.name);
#define LICHTRAUM_SHARE(name, initial) LICHTRAUM_COLOR(name, initial)
#define LICHTRAUM_NUMBER(name, initial, least, most) has_changed |= edit_field(#name, model.name, least, most);
  PHONG_FIELDS(LICHTRAUM_COLOR, LICHTRAUM_SHARE, LICHTRAUM_NUMBER)
#undef LICHTRAUM_COLOR
#undef LICHTRAUM_SHARE
#undef LICHTRAUM_NUMBER
  // What one takes beyond their sum of 1, the other gives.
  if (model.reflect != before.reflect) {
    model.transmit = std::min(model.transmit, rest_of(model.reflect));
  } else {
    model.reflect = std::min(model.reflect, rest_of(model.transmit));
  }
  return has_changed;
}

/// Whether the field shows at all.
bool has_effect(PbrModel const& model, void const* field) {
  if (field == &model.alpha) return model.alpha_mode == AlphaMode::blend;
  if (field == &model.alpha_cutoff) return model.alpha_mode == AlphaMode::mask;
  if (field == &model.normal_scale) return bool(model.normal_texture);
  if (field == &model.clearcoat_normal_scale) return bool(model.clearcoat_normal_texture);
  if (field == &model.occlusion_strength) return bool(model.occlusion_texture);
  return true;
}

bool edit(PbrModel& model) {
  bool has_changed = false;
#define LICHTRAUM_COLOR(name, initial, extension, key) \
  if (has_effect(model, &model.name)) has_changed |= edit_field(label_of(#name).c_str(), model.name);
#define LICHTRAUM_SHARE(name, initial, extension, key) LICHTRAUM_COLOR(name, initial, extension, key)
#define LICHTRAUM_NUMBER(name, initial, least, most, extension, key) \
  if (has_effect(model, &model.name)) has_changed |= edit_field(label_of(#name).c_str(), model.name, least, most);
#define LICHTRAUM_NONE(...)
  PBR_DEVICE_FIELDS(LICHTRAUM_COLOR, LICHTRAUM_SHARE, LICHTRAUM_NUMBER, LICHTRAUM_NONE, LICHTRAUM_NONE)
#undef LICHTRAUM_COLOR
#undef LICHTRAUM_SHARE
#undef LICHTRAUM_NUMBER
#undef LICHTRAUM_NONE
  return has_changed;
}

}  // namespace

bool edit_light(Light& light, Light const& original, double scene_size) {
  Light::Model model = light.model();
  EditLight edit(original.brightness(), scene_size);
  std::visit([&](auto& edited) { for_each_field(edited, edit); }, model);
  if (edit.has_changed) light = Light(light.name(), std::move(model));
  return edit.has_changed;
}

bool edit_material(Material& material) {
  Material::Model model = material.model();
  bool const has_changed = std::visit([](auto& edited) { return edit(edited); }, model);
  if (has_changed) material = Material(material.name(), std::move(model));
  return has_changed;
}

}  // namespace lichtraum::view
