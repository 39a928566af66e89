#pragma once

namespace lichtraum {

/// Of linear sRGB, by ITU-R BT.709.
inline double luminance(float const* rgb) {
  return 0.2126 * double(rgb[0]) + 0.7152 * double(rgb[1]) + 0.0722 * double(rgb[2]);
}

}  // namespace lichtraum
