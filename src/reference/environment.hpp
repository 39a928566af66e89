#pragma once

#include <optional>

#include "lichtraum/environment.hpp"
#include "lichtraum/math.hpp"

namespace lichtraum {

/// What arrives from infinitely far away: the definition of environment_radiance in kernels/lights/environment.clh.
class ReferenceEnvironment {
 public:
  ReferenceEnvironment() = default;  ///< none: black
  explicit ReferenceEnvironment(EnvironmentLight light);

  explicit operator bool() const { return light_.map != nullptr; }

  /// From a unit direction of the world.
  Rgb radiance(Vec3 const& direction) const;

 private:
  Rgb texel(int row, int column) const;
  Rgb mean_of_row(int row) const;
  Rgb value(int row, double column) const;

  EnvironmentLight light_;
  Rgb north_{0}, south_{0};
  double cosine_ = 1, sine_ = 0;
};

}  // namespace lichtraum
