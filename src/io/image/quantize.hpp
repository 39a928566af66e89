#pragma once

#include <cstddef>
#include <cstdint>

namespace lichtraum {

/// [0, 1] to the nearest of 0..max. What lies outside is clamped (infinity too); NaN is 0.
template <std::uint32_t max>
std::uint32_t quantize(float value) {
  if (!(value > 0)) return 0;  // NaN comes here
  if (value >= 1) return max;
  // In double: in float, 0.49999997f + 0.5f is already 1.
  return static_cast<std::uint32_t>(double(value) * max + 0.5);
}

/// `count` values as one byte each.
inline void quantize_8(float const* values, std::size_t count, unsigned char* out) {
  for (std::size_t i = 0; i < count; ++i) out[i] = static_cast<unsigned char>(quantize<255>(values[i]));
}

/// `count` values as two bytes each, the high one first (PNG's and PPM's order).
inline void quantize_16(float const* values, std::size_t count, unsigned char* out) {
  for (std::size_t i = 0; i < count; ++i) {
    std::uint32_t const value = quantize<65535>(values[i]);
    out[2 * i] = static_cast<unsigned char>(value >> 8);
    out[2 * i + 1] = static_cast<unsigned char>(value & 0xff);
  }
}

}  // namespace lichtraum
