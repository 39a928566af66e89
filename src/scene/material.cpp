#include "lichtraum/material.hpp"

#include <cmath>
#include <ostream>
#include <stdexcept>

#include "core/format_numbers.hpp"
#include "scene/check_finite.hpp"
#include "scene/pbr_evaluation.hpp"

namespace lichtraum {
namespace {

void check_field(char const* name, Rgb const& color, Rgb const&) {
  check_finite(color, fmt::format("a material's {}", name));
}
/// What is infinite unless somebody says otherwise may be so.
void check_field(char const* name, double number, double initial) {
  if (number != initial) check_finite(number, fmt::format("a material's {}", name));
}
void check_field(char const* name, TextureSlot const& slot) {
  for (double const number : {slot.offset.x, slot.offset.y, slot.rotation_radians, slot.scale.x, slot.scale.y}) {
    check_finite(number, fmt::format("the place of a material's {}", name));
  }
}

#define LICHTRAUM_CHECK(name, ...) check_field(#name, model.name, Initial().name);
#define LICHTRAUM_CHECK_TEXTURE(name, ...) check_field(#name, model.name);
#define LICHTRAUM_NONE(...)
void check(PhongModel const& model) {
  using Initial = PhongModel;
  PHONG_FIELDS(LICHTRAUM_CHECK, LICHTRAUM_CHECK, LICHTRAUM_CHECK)
  // Decimals that add up to 1 on paper may be an ulp above it.
  constexpr double sum_limit = 1 + 1e-12;
  bool const are_shares = model.reflect >= 0 && model.transmit >= 0 && model.reflect <= 1 && model.transmit <= 1;
  if (!are_shares || !(model.reflect + model.transmit <= sum_limit)) {
    throw std::invalid_argument("reflect, transmit and their sum must lie in 0..1");
  }
  if (!(model.ior > 0)) throw std::invalid_argument("the index of refraction must be positive");
}
void check(PbrModel const& model) {  // any that is finite can be drawn
  using Initial = PbrModel;
  PBR_FIELDS(LICHTRAUM_CHECK, LICHTRAUM_CHECK, LICHTRAUM_CHECK, LICHTRAUM_CHECK_TEXTURE, LICHTRAUM_NONE)
}
#undef LICHTRAUM_CHECK
#undef LICHTRAUM_CHECK_TEXTURE

std::string text_of(Rgb const& color) { return format_numbers(color); }
std::string text_of(double number) { return fmt::format("{}", number); }

// Of one field that is not what it is at first.
#define LICHTRAUM_CHANGE(name, ...) \
  if (model.name != Initial().name) out += fmt::format(", " #name " {}", text_of(model.name));

std::string text_of(PhongModel const& model) {
  using Initial = PhongModel;
  std::string out;
#define LICHTRAUM_FIELD(name, ...) out += fmt::format(", " #name " {}", text_of(model.name));
  PHONG_STANDARD_FIELDS(LICHTRAUM_FIELD, LICHTRAUM_FIELD, LICHTRAUM_FIELD)
#undef LICHTRAUM_FIELD
  PHONG_OPTIONAL_FIELDS(LICHTRAUM_CHANGE, LICHTRAUM_CHANGE, LICHTRAUM_CHANGE)
  return out.substr(2);
}

std::string text_of(PbrModel const& model) {
  using Initial = PbrModel;
  std::string out = "metallic-roughness";
#define LICHTRAUM_TEXTURE(name, ...) \
  if (model.name) out += ", " #name;
#define LICHTRAUM_MODE(type, name, initial) \
  if (model.name != initial) out += ", " #name;
  PBR_FIELDS(LICHTRAUM_CHANGE, LICHTRAUM_CHANGE, LICHTRAUM_CHANGE, LICHTRAUM_TEXTURE, LICHTRAUM_MODE)
#undef LICHTRAUM_TEXTURE
#undef LICHTRAUM_MODE
  return out;
}
#undef LICHTRAUM_CHANGE
#undef LICHTRAUM_NONE

}  // namespace

Material::Material(std::string name, Rgb const& ka, Rgb const& kd, Rgb const& ks, double m)
    : Material(std::move(name), PhongModel{.ka = ka, .kd = kd, .ks = ks, .m = m}) {}

Material::Material(std::string name, Model model) : name_(std::move(name)), model_(std::move(model)) {
  std::visit([](auto const& checked) { check(checked); }, model_);
}

PhongModel Material::phong() const {
  PbrModel const* const metallic = pbr();
  return metallic ? phong_at(*metallic, MeshPoint()) : std::get<PhongModel>(model_);
}

std::ostream& operator<<(std::ostream& out, Material const& material) {
  return out << fmt::format("material '{}': ", material.name())
             << std::visit([](auto const& model) { return text_of(model); }, material.model());
}

}  // namespace lichtraum
