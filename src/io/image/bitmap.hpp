#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "lichtraum/pbr_model.hpp"

namespace lichtraum {

// What TGA and BMP have in common.

/// The whole number of so many bytes (1 to 4) at `first`, the lowest one first. All of them must be there.
inline std::uint32_t little_endian(std::string_view bytes, std::size_t first, std::size_t count) {
  std::uint32_t value = 0;
  for (std::size_t i = count; i-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[first + i]);
  return value;
}

using Rgba8 = std::array<std::uint8_t, 4>;

/// Of three bytes, or four.
inline Rgba8 color_of_bgra(std::string_view bytes, std::size_t at, bool has_alpha) {
  auto const byte = [&](std::size_t i) { return static_cast<std::uint8_t>(bytes[at + i]); };
  return {byte(2), byte(1), byte(0), has_alpha ? byte(3) : std::uint8_t(255)};
}

/// 0 to `largest`, as 0 to 255.
inline std::uint8_t scaled_to_8(std::uint32_t value, std::uint32_t largest) {
  return std::uint8_t((std::uint64_t(value) * 255 + largest / 2) / largest);
}

/// Makes a picture opaque of which nothing would be seen.
inline void fill_empty_alpha(TextureImage& image) {
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) {
    if (image.rgba[i] != 0) return;
  }
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) image.rgba[i] = 255;
}

}  // namespace lichtraum
