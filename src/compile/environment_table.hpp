#pragma once

#include <array>
#include <memory>

#include "compile/scene_arrays.hpp"
#include "lichtraum/environment.hpp"
#include "lichtraum/math.hpp"

namespace lichtraum {

/// An environment's map as the kernels read it: all that does not depend on its rotation and brightness.
struct EnvironmentTable : device::EnvironmentArrays {
  std::shared_ptr<EnvironmentMap const> map;
  double mean_luminance = 0;          ///< over the sphere
  double sampled_mean_luminance = 0;  ///< of what the table chooses by; 0: it chooses nothing
  std::array<float, 6> poles{};       ///< the mean of the first row, and of the last
  Rgb on_level{0};                    ///< irradiance on a level surface, from above, over pi
};

/// Directions are chosen by the luminance that arrives, as the kernels interpolate it. `is_compensated`: by what of it
/// is above its mean, as multiple importance sampling has other samples for the rest (Karlik et al., "MIS Compensation:
/// Optimizing Sampling Techniques in Multiple Importance Sampling", ACM Transactions on Graphics 38(6), 2019).
/// The map must have texels. Takes a few hundred milliseconds for 8192 x 4096 of them; the same bytes on any number of
/// cores.
EnvironmentTable make_environment_table(std::shared_ptr<EnvironmentMap const> map, bool is_compensated = true);

/// Fills what `constants` say of it.
void set_environment(device::SceneConstants& constants, EnvironmentTable const& table, EnvironmentLight const& light,
                     Vec3 const& up);

}  // namespace lichtraum
