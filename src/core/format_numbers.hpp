#pragma once

#include <fmt/format.h>

#include <string>

#include "lichtraum/math.hpp"

namespace lichtraum {

/// "1 0.5 -3": the shortest decimals that mean the same numbers, whatever the locale.
inline std::string format_numbers(Vec3 const& v) { return fmt::format("{} {} {}", v.x, v.y, v.z); }

}  // namespace lichtraum
