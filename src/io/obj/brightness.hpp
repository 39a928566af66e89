#pragma once

#include <cstdint>

namespace lichtraum::obj {

/// How bright a pixel of red, green and blue is, by Rec. 709's weights in 256ths: what MTL's scalar maps mean.
inline int brightness_of(std::uint8_t const* pixel) { return (54 * pixel[0] + 183 * pixel[1] + 19 * pixel[2]) / 256; }

}  // namespace lichtraum::obj
