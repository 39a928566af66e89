#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

/// Independent readers for what lichtraum writes.

struct DecodedImage {
  int width = 0;
  int height = 0;
  int max = 0;                ///< 255 or 65535; 0 for float formats
  std::vector<float> values;  ///< height x width x 3, as stored, first row at the top

  std::vector<float> alpha = {};  ///< height x width; empty without

  float at(int x, int y, int channel) const {
    return values.at(3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)) +
                     static_cast<std::size_t>(channel));
  }
};

/// A channel of an OpenEXR file: height x width. Throws std::runtime_error when there is none of that name.
std::vector<float> decode_exr_floats(std::string_view bytes, char const* channel);
std::vector<std::uint32_t> decode_exr_numbers(std::string_view bytes, char const* channel);

/// By its first bytes: PPM (P3, P6), PNG, JPEG, OpenEXR (R, G and B) or PFM (one channel becomes three). Throws
/// std::runtime_error when it is another format or broken.
DecodedImage decode(std::string_view bytes);
