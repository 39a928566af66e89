#pragma once

#include <iosfwd>
#include <limits>
#include <string>
#include <string_view>

#include "lichtraum/math.hpp"

namespace lichtraum {

enum class LightKind {
  ambient,      ///< La everywhere
  point,        ///< from a position, into all directions; may add an ambient La (SDF's `define light`)
  spot,         ///< from a position, into a cone
  directional,  ///< from infinitely far away
};

/// Full brightness within the inner angle, none beyond the outer one; both from the cone's middle, degrees.
/// 0 <= inner < outer <= 90.
struct SpotCone {
  double inner_degrees = 0;
  double outer_degrees = 45;
};

class Light {
 public:
  /// A white point light at the origin without a name.
  Light() = default;
  static Light ambient(std::string name, Rgb const& la);
  /// As bright at any distance: SDF's.
  static Light point(std::string name, Vec3 const& position, Rgb const& ld, Rgb const& la = Rgb{0});
  /// Falls off with the square of the distance, and to nothing at `range` (KHR_lights_punctual's formula). `intensity`
  /// is what arrives at distance 1. Throws std::invalid_argument unless range > 0.
  static Light falling_off(std::string name, Vec3 const& position, Rgb const& intensity,
                           double range = std::numeric_limits<double>::infinity());
  /// The same within a cone about `direction` (not zero). Also throws for invalid angles.
  static Light spot(std::string name, Vec3 const& position, Vec3 const& direction, Rgb const& intensity,
                    SpotCone const& cone, double range = std::numeric_limits<double>::infinity());
  /// Shines along `direction` (not zero, else throws std::invalid_argument); `ld` arrives everywhere.
  static Light directional(std::string name, Vec3 const& direction, Rgb const& ld);

  std::string const& name() const { return name_; }
  LightKind kind() const { return kind_; }
  bool has_position() const { return kind_ == LightKind::point || kind_ == LightKind::spot; }
  Vec3 const& position() const { return position_; }  ///< in the world; of a point or spot light
  Vec3 const& direction() const {
    return direction_;
  }                                      ///< where it shines, unit length; of a spot or directional light
  Rgb const& la() const { return la_; }  ///< ambient term
  Rgb const& ld() const { return ld_; }  ///< what arrives at a surface; of a light that falls off, at distance 1

  bool falls_off() const { return falls_off_; }   ///< with the square of the distance
  double range() const { return range_; }         ///< infinite: no end
  SpotCone const& cone() const { return cone_; }  ///< of a spot light

  /// What arrives at a point of the world when nothing stands between.
  Rgb arriving_at(Vec3 const& point) const;

 private:
  std::string name_;
  LightKind kind_ = LightKind::point;
  Vec3 position_{0};
  Vec3 direction_{0, 0, -1};
  Rgb la_{0};
  Rgb ld_{1};
  bool falls_off_ = false;
  double range_ = std::numeric_limits<double>::infinity();
  SpotCone cone_;
};

/// "ambient", "point", "spot" or "directional".
std::string_view name_of(LightKind kind);

std::ostream& operator<<(std::ostream& out, Light const& light);

}  // namespace lichtraum
