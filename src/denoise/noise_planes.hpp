#pragma once

#include <vector>

#include "lichtraum/denoise.hpp"
#include "shared/denoise.h"

namespace lichtraum {

/// What the built-in filter works on, as kernels/shared/denoise.h lays it out.
struct NoisePlanes {
  device::NoiseFilterLayout layout{};
  std::vector<float> guides;     ///< GUIDE_PLANES planes
  std::vector<float> light;      ///< LIGHT_PLANES planes; afterwards without noise
  std::vector<float> filtered;   ///< LIGHT_PLANES planes, for every other pass
  std::vector<float> luminance;  ///< LUMINANCE_PLANES planes
};

/// With the picture's guides and its light: radiance divided by albedo. Throws std::invalid_argument as
/// lichtraum::filter_noise does.
NoisePlanes noise_planes(NoisyPicture const& picture);

/// The light that the planes hold as radiance again, height x width x 3.
std::vector<float> radiance_of(NoisePlanes const& planes, NoisyPicture const& picture);

}  // namespace lichtraum
