#pragma once

namespace lichtraum {

/// Of light that is sent out, in a channel: sums of many samples stay numbers.
inline constexpr double largest_radiance = 1e30;

}  // namespace lichtraum
