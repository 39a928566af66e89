#pragma once

#include <iosfwd>
#include <string>

#include "lichtraum/math.hpp"

namespace lichtraum {

enum class LightKind {
  ambient,  ///< La everywhere
  point,    ///< Ld from a position, no fall-off with distance; may add an ambient La (SDF's `define light`)
};

class Light {
 public:
  /// A white point light at the origin without a name.
  Light() = default;
  static Light ambient(std::string name, Rgb const& la);
  static Light point(std::string name, Vec3 const& position, Rgb const& ld, Rgb const& la = Rgb{0});

  std::string const& name() const { return name_; }
  LightKind kind() const { return kind_; }
  Vec3 const& position() const { return position_; }  ///< in the world; meaningless for an ambient light
  Rgb const& la() const { return la_; }               ///< ambient term
  Rgb const& ld() const { return ld_; }               ///< diffuse and specular term; zero for an ambient light

 private:
  std::string name_;
  LightKind kind_ = LightKind::point;
  Vec3 position_{0};
  Rgb la_{0};
  Rgb ld_{1};
};

std::ostream& operator<<(std::ostream& out, Light const& light);

}  // namespace lichtraum
