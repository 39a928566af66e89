#pragma once

#include "lichtraum/math.hpp"

namespace lichtraum {

/// Of linear sRGB, by ITU-R BT.709.
inline double luminance(float const* rgb) {
  return 0.2126 * double(rgb[0]) + 0.7152 * double(rgb[1]) + 0.0722 * double(rgb[2]);
}
inline double luminance(Rgb const& color) { return glm::dot(color, Rgb(0.2126, 0.7152, 0.0722)); }

}  // namespace lichtraum
