#pragma once

#include "lichtraum/math.hpp"

namespace lichtraum {

/// Of linear sRGB, by ITU-R BT.709.
inline double luminance(Rgb const& color) { return 0.2126 * color.r + 0.7152 * color.g + 0.0722 * color.b; }
inline double luminance(float const* rgb) { return luminance(Rgb(rgb[0], rgb[1], rgb[2])); }

}  // namespace lichtraum
