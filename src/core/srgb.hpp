#pragma once

#include "core/elementary.hpp"

namespace lichtraum {

/// sRGB's transfer function, IEC 61966-2-1, for one component: a straight line near black, then a power. Kernels have
/// the decoding of eight bits as a table (shared/srgb.h).
inline double linear_from_srgb(double c) { return c <= 0.04045 ? c / 12.92 : pow_of((c + 0.055) / 1.055, 2.4); }
inline double srgb_from_linear(double c) { return c <= 0.0031308 ? 12.92 * c : 1.055 * pow_of(c, 1 / 2.4) - 0.055; }

}  // namespace lichtraum
