#pragma once

#include <concepts>
#include <iosfwd>
#include <limits>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>

#include "lichtraum/api.hpp"
#include "lichtraum/math.hpp"

namespace LICHTRAUM_API lichtraum {

/// Full brightness within the inner angle, none beyond the outer one; both from the cone's middle, degrees.
/// 0 <= inner < outer <= 90.
struct SpotCone {
  double inner_degrees = 0;
  double outer_degrees = 45;
  friend bool operator==(SpotCone const&, SpotCone const&) = default;
};

/// What for_each_field calls for the fields of a light, by their names. Visitors derive from it and have functions of
/// their own for what they look at.
struct LightFieldVisitor {
  void position(char const*, Vec3 const&) const {}
  void direction(char const*, Vec3 const&) const {}
  void brightness(char const*, Rgb const&) const {}
  void ambient(char const*, Rgb const&) const {}
  void flag(char const*, bool) const {}
  void range(char const*, double) const {}
  void cone(char const*, SpotCone const&) const {}
  void radius(char const*, double) const {}
};

// The fields of each kind of light, written down once: the structs below come from these lists, and what goes through
// for_each_field: how lights are printed, what `info --json` says of them, the window's sliders.
//
//   POSITION    in the world
//   DIRECTION   where it shines: in the world, of unit length
//   BRIGHTNESS  rgb: what arrives at a surface; where it falls off with the distance, at distance 1
//   AMBIENT     rgb: arrives everywhere, whatever stands between
//   FLAG
//   RANGE       at this distance it has fallen off to nothing (KHR_lights_punctual's formula); > 0, infinite: no end
//   CONE
//   RADIUS      in units of the world, >= 0: from each point the light is seen as a disc of that radius around its
//               position, which no ray meets; 0: as a point. Only paths show it

/// Arrives everywhere.
#define LICHTRAUM_AMBIENT_LIGHT(POSITION, DIRECTION, BRIGHTNESS, AMBIENT, FLAG, RANGE, CONE, RADIUS) BRIGHTNESS(la, 0)

/// From a position, into all directions; as bright at any distance (eSDF's), or falling off with its square (glTF's).
#define LICHTRAUM_POINT_LIGHT(POSITION, DIRECTION, BRIGHTNESS, AMBIENT, FLAG, RANGE, CONE, RADIUS) \
  BRIGHTNESS(ld, 1) AMBIENT(la) POSITION(position) FLAG(falls_off) RANGE(range) RADIUS(radius)

/// From a position, into a cone; falls off with the square of the distance.
#define LICHTRAUM_SPOT_LIGHT(POSITION, DIRECTION, BRIGHTNESS, AMBIENT, FLAG, RANGE, CONE, RADIUS) \
  BRIGHTNESS(ld, 1) POSITION(position) DIRECTION(direction) CONE(cone) RANGE(range)

/// From infinitely far away.
#define LICHTRAUM_DIRECTIONAL_LIGHT(POSITION, DIRECTION, BRIGHTNESS, AMBIENT, FLAG, RANGE, CONE, RADIUS) \
  BRIGHTNESS(ld, 1) DIRECTION(direction)

#define LICHTRAUM_POSITION(name) Vec3 name{0};
#define LICHTRAUM_DIRECTION(name) Vec3 name{0, 0, -1};
#define LICHTRAUM_BRIGHTNESS(name, initial) Rgb name{initial};
#define LICHTRAUM_AMBIENT(name) Rgb name{0};
#define LICHTRAUM_FLAG(name) bool name = false;
#define LICHTRAUM_RANGE(name) double name = std::numeric_limits<double>::infinity();
#define LICHTRAUM_CONE(name) SpotCone name{};
#define LICHTRAUM_RADIUS(name) double name = 0;
#define LICHTRAUM_VISIT_POSITION(name) visitor.position(#name, light.name);
#define LICHTRAUM_VISIT_DIRECTION(name) visitor.direction(#name, light.name);
#define LICHTRAUM_VISIT_BRIGHTNESS(name, initial) visitor.brightness(#name, light.name);
#define LICHTRAUM_VISIT_AMBIENT(name) visitor.ambient(#name, light.name);
#define LICHTRAUM_VISIT_FLAG(name) visitor.flag(#name, light.name);
#define LICHTRAUM_VISIT_RANGE(name) visitor.range(#name, light.name);
#define LICHTRAUM_VISIT_CONE(name) visitor.cone(#name, light.name);
#define LICHTRAUM_VISIT_RADIUS(name) visitor.radius(#name, light.name);
#define LICHTRAUM_LIGHT(type, word, fields)                                                                          \
  struct type {                                                                                                      \
    static constexpr std::string_view kind = word;                                                                   \
    friend bool operator==(type const&, type const&) = default;                                                      \
    fields(LICHTRAUM_POSITION, LICHTRAUM_DIRECTION, LICHTRAUM_BRIGHTNESS, LICHTRAUM_AMBIENT, LICHTRAUM_FLAG,         \
           LICHTRAUM_RANGE, LICHTRAUM_CONE, LICHTRAUM_RADIUS)                                                        \
  };                                                                                                                 \
  template <class Visitor, class Light>                                                                              \
  requires std::same_as<std::remove_const_t<Light>, type>                                                            \
  void for_each_field(Light& light, Visitor& visitor) {                                                              \
    fields(LICHTRAUM_VISIT_POSITION, LICHTRAUM_VISIT_DIRECTION, LICHTRAUM_VISIT_BRIGHTNESS, LICHTRAUM_VISIT_AMBIENT, \
           LICHTRAUM_VISIT_FLAG, LICHTRAUM_VISIT_RANGE, LICHTRAUM_VISIT_CONE, LICHTRAUM_VISIT_RADIUS)                \
  }

LICHTRAUM_LIGHT(AmbientLight, "ambient", LICHTRAUM_AMBIENT_LIGHT)
LICHTRAUM_LIGHT(PointLight, "point", LICHTRAUM_POINT_LIGHT)
LICHTRAUM_LIGHT(SpotLight, "spot", LICHTRAUM_SPOT_LIGHT)
LICHTRAUM_LIGHT(DirectionalLight, "directional", LICHTRAUM_DIRECTIONAL_LIGHT)

#undef LICHTRAUM_AMBIENT_LIGHT
#undef LICHTRAUM_POINT_LIGHT
#undef LICHTRAUM_SPOT_LIGHT
#undef LICHTRAUM_DIRECTIONAL_LIGHT
#undef LICHTRAUM_POSITION
#undef LICHTRAUM_DIRECTION
#undef LICHTRAUM_BRIGHTNESS
#undef LICHTRAUM_AMBIENT
#undef LICHTRAUM_FLAG
#undef LICHTRAUM_RANGE
#undef LICHTRAUM_CONE
#undef LICHTRAUM_RADIUS
#undef LICHTRAUM_VISIT_POSITION
#undef LICHTRAUM_VISIT_DIRECTION
#undef LICHTRAUM_VISIT_BRIGHTNESS
#undef LICHTRAUM_VISIT_AMBIENT
#undef LICHTRAUM_VISIT_FLAG
#undef LICHTRAUM_VISIT_RANGE
#undef LICHTRAUM_VISIT_CONE
#undef LICHTRAUM_VISIT_RADIUS
#undef LICHTRAUM_LIGHT

class Light {
 public:
  using Model = std::variant<PointLight, AmbientLight, SpotLight, DirectionalLight>;

  /// A white point light at the origin without a name.
  Light() = default;
  /// Brings directions to unit length. Throws std::invalid_argument for a direction that is zero, a range that is not
  /// positive, angles that make no cone, a radius that is negative, and numbers that are not finite, but for a range.
  Light(std::string name, Model model);

  static Light ambient(std::string name, Rgb const& la);
  /// As bright at any distance: eSDF's.
  static Light point(std::string name, Vec3 const& position, Rgb const& ld, Rgb const& la = Rgb{0});
  static Light falling_off(std::string name, Vec3 const& position, Rgb const& intensity,
                           double range = std::numeric_limits<double>::infinity());
  static Light spot(std::string name, Vec3 const& position, Vec3 const& direction, Rgb const& intensity,
                    SpotCone const& cone, double range = std::numeric_limits<double>::infinity());
  static Light directional(std::string name, Vec3 const& direction, Rgb const& ld);

  std::string const& name() const { return name_; }
  Model const& model() const { return model_; }
  template <class Kind>
  Kind const* get() const {
    return std::get_if<Kind>(&model_);
  }
  std::string_view kind() const;  ///< "ambient", "point", "spot" or "directional"

  Rgb la() const;                          ///< its ambient term
  Rgb brightness() const;                  ///< what arrives; of a light that falls off, at distance 1
  bool casts_shadows() const;              ///< false: there is nothing of it but la
  Vec3 const* position() const;            ///< in the world; null for one without
  Vec3 way_from(Vec3 const& point) const;  ///< to its position; without one, the unit vector against its direction
  /// What arrives at a point of the world, besides la, when nothing stands between.
  Rgb arriving_at(Vec3 const& point) const;

  friend bool operator==(Light const&, Light const&) = default;

 private:
  std::string name_;
  Model model_;
};

std::ostream& operator<<(std::ostream& out, Light const& light);

}  // namespace lichtraum
