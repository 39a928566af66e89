#pragma once

#include <algorithm>

#include "lichtraum/math.hpp"

namespace lichtraum {

inline double largest_channel(Rgb const& color) { return std::max({color.r, color.g, color.b}); }

}  // namespace lichtraum
