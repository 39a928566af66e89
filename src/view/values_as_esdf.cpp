#include "view/values_as_esdf.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace lichtraum::view {
namespace {

std::string text_of(double number) { return fmt::format("{}", number); }
template <class Triple>
std::string text_of(Triple const& v) {
  return fmt::format("{} {} {}", v[0], v[1], v[2]);
}

std::string key(char const* name, double number) { return fmt::format(" {}={}", name, number); }
std::string key(char const* name, Rgb const& color) { return fmt::format(" {} {}", name, text_of(color)); }

}  // namespace

std::string word_of(std::string name) {
  auto const is_kept = [](unsigned char c) {  // bytes of UTF-8 are letters
    return c >= 0x80 || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' ||
           c == '-' || c == '_';
  };
  std::replace_if(
      name.begin(), name.end(), [&](char c) { return !is_kept(static_cast<unsigned char>(c)); }, '_');
  return name.empty() ? "unnamed" : name;
}

std::string material_statement(std::string_view name, Material const& material) {
  PhongModel const model = material.phong();
  std::string text = fmt::format("define material {}", name);
#define LICHTRAUM_STANDARD(name, ...) text += "  " + text_of(model.name);
  PHONG_STANDARD_FIELDS(LICHTRAUM_STANDARD, LICHTRAUM_STANDARD, LICHTRAUM_STANDARD)
#undef LICHTRAUM_STANDARD
#define LICHTRAUM_OPTIONAL(name, ...) \
  if (model.name != PhongModel().name) text += key(#name, model.name);
  PHONG_OPTIONAL_FIELDS(LICHTRAUM_OPTIONAL, LICHTRAUM_OPTIONAL, LICHTRAUM_OPTIONAL)
#undef LICHTRAUM_OPTIONAL
  return text;
}

std::string light_statement(std::string_view name, Light const& light) {
  if (auto const* const ambient = light.get<AmbientLight>()) {
    return fmt::format("define light ambient {}  {}", name, text_of(ambient->la));
  }
  auto const* const point = light.get<PointLight>();
  if (!point || point->falls_off) return fmt::format("# {}: eSDF has no {} light that is like it", name, light.kind());
  std::string const radius = point->radius > 0 ? key("radius", point->radius) : "";
  std::string const position = text_of(point->position), ld = text_of(point->ld);
  if (point->la == Rgb(0)) return fmt::format("define light diffuse {}  {}  {}{}", name, position, ld, radius);
  return fmt::format("define light {}  {}  {}  {}{}", name, position, text_of(point->la), ld, radius);
}

std::string material_as_esdf(Material const& material) {
  return material_statement(word_of(material.name()), material) + '\n';
}

std::string light_as_esdf(Light const& light) { return light_statement(word_of(light.name()), light) + '\n'; }

}  // namespace lichtraum::view
