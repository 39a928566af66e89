#pragma once

#include <optional>

#include "lichtraum/environment.hpp"
#include "lichtraum/math.hpp"
#include "lichtraum/transform.hpp"

namespace lichtraum {

/// What arrives from infinitely far away: the definition of environment_radiance in kernels/lights/environment.clh.
class ReferenceEnvironment {
 public:
  ReferenceEnvironment() = default;  ///< none: black
  /// `up`: of the scene.
  explicit ReferenceEnvironment(EnvironmentLight light, Vec3 const& up = {0, 1, 0});

  explicit operator bool() const { return light_.map != nullptr; }

  /// From a unit direction of the world.
  Rgb radiance(Vec3 const& direction) const;

 private:
  Rgb texel(int row, int column) const;
  Rgb mean_of_row(int row) const;
  Rgb value(int row, double column) const;

  EnvironmentLight light_;
  Rgb north_{0}, south_{0};
  Transform map_from_world_;
};

}  // namespace lichtraum
