#include "io/ply/columns.hpp"

#include <algorithm>
#include <span>

#include "core/ascii.hpp"

namespace lichtraum::ply {
namespace {

using Slot = Columns::Slot;
using enum Columns::Slot;

struct SlotName {
  std::string_view name;
  Slot slot;
};
constexpr SlotName number_names[] = {
    {"x", x},
    {"y", y},
    {"z", z},
    {"nx", nx},
    {"ny", ny},
    {"nz", nz},
    {"normal_x", nx},
    {"normal_y", ny},
    {"normal_z", nz},
    {"u", u},
    {"v", v},
    {"s", u},
    {"t", v},
    {"texture_u", u},
    {"texture_v", v},
    {"texture_s", u},
    {"texture_t", v},
    {"texcoord_x", u},
    {"texcoord_y", v},
    {"red", red},
    {"green", green},
    {"blue", blue},
    {"alpha", alpha},
    {"r", red},
    {"g", green},
    {"b", blue},
    {"a", alpha},
    {"diffuse_red", red},
    {"diffuse_green", green},
    {"diffuse_blue", blue},
    {"vertex1", begin},
    {"vertex2", end},
    {"texnumber", picture},
};
constexpr SlotName list_names[] = {
    {"vertex_indices", corners},
    {"vertex_index", corners},
    {"texcoord", texcoords},
};

constexpr SlotName splat_names[] = {
    {"f_dc_0", red},
    {"f_dc_1", green},
    {"f_dc_2", blue},
    {"opacity", opacity},
};
/// One over the first spherical harmonic, which is the same in all directions: 2 sqrt(pi).
constexpr double splat_divisor = 3.5449077018110318;

Slot slot_of(Property const& property, std::span<SlotName const> names) {
  std::string const word = to_lower_ascii(property.name);
  for (SlotName const& known : names) {
    if (known.name == word) return known.slot;
  }
  return none;
}

bool is_float(Type type) { return type == Type::float32 || type == Type::float64; }

/// The largest value of a colour's type.
double full_scale(Type type, double float_white) {
  switch (type) {
    case Type::int8:
      return 127;
    case Type::uint8:
      return 255;
    case Type::int16:
      return 32767;
    case Type::uint16:
      return 65535;
    case Type::int32:
    case Type::uint32:
      return 255;  // colours of 0..255 that were written carelessly
    case Type::float32:
    case Type::float64:
      return float_white;
  }
  return 1;
}

bool are_splats_without_colors(Element const& element) {
  auto const has = [&](Slot slot, std::span<SlotName const> names) {
    return std::ranges::any_of(element.properties,
                               [&](Property const& p) { return !p.is_list && slot_of(p, names) == slot; });
  };
  auto const has_colors = [&](std::span<SlotName const> names) {
    return has(red, names) && has(green, names) && has(blue, names);
  };
  return has_colors(splat_names) && !has_colors(number_names);
}

}  // namespace

Columns::Columns(Element const& element, double float_white) : are_splats(are_splats_without_colors(element)) {
  for (Property const& property : element.properties) {
    Slot slot = slot_of(property, property.is_list ? std::span<SlotName const>(list_names) : number_names);
    Slot const of_splat = are_splats && !property.is_list ? slot_of(property, splat_names) : none;
    Range range;
    if (of_splat != none) {
      slot = of_splat;
      if (slot != opacity) range = {.divisor = splat_divisor, .offset = 0.5, .is_clamped = true};
    } else if (slot == alpha) {
      range.divisor = full_scale(property.type, 1);
    } else if (slot == red || slot == green || slot == blue) {
      range = {.divisor = full_scale(property.type, float_white), .is_float_color = is_float(property.type)};
    }
    slots.push_back(slot);
    ranges.push_back(range);
    has[slot] = true;
  }
}

}  // namespace lichtraum::ply
