#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "lichtraum/image.hpp"

namespace lichtraum::view {

/// A picture as a window's texture holds it: red, green, blue and 255, a byte each, first row at the top.
inline std::vector<unsigned char> display_pixels(Image const& image) {
  std::vector<float> const& values = image.data();
  std::vector<unsigned char> bytes(values.size() / 3 * 4);
  for (std::size_t i = 0; i < values.size() / 3; ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      float const value = values[3 * i + c];
      bytes[4 * i + c] = static_cast<unsigned char>(value > 0 ? std::min(value, 1.0f) * 255 + 0.5f : 0);
    }
    bytes[4 * i + 3] = 255;
  }
  return bytes;
}

}  // namespace lichtraum::view
