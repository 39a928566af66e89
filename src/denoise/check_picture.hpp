#pragma once

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "lichtraum/denoise.hpp"

namespace lichtraum {

/// Throws std::invalid_argument for planes of another size than the picture's.
inline void check_picture(NoisyPicture const& picture) {
  auto const pixels = std::size_t(picture.size.width) * std::size_t(picture.size.height);
  auto const fits = [&](std::vector<float> const& plane, std::size_t channels) {
    return plane.empty() || plane.size() == channels * pixels;
  };
  if (picture.radiance.size() != 3 * pixels || !fits(picture.albedo, 3) || !fits(picture.normal, 3) ||
      !fits(picture.depth, 1)) {
    throw std::invalid_argument("the planes of a picture are of one size");
  }
}

inline float finite(float value) { return std::isfinite(value) ? value : 0.0f; }

inline std::vector<float> finite_values(std::vector<float> values) {
  std::ranges::transform(values, values.begin(), finite);
  return values;
}

}  // namespace lichtraum
