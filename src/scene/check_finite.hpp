#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <string_view>

#include "core/float3.hpp"

namespace lichtraum {

// Throw std::invalid_argument for infinite numbers and what is no number. `what`: "a light's position".

inline void check_finite(double number, std::string_view what) {
  if (!std::isfinite(number)) throw std::invalid_argument(fmt::format("{} must be finite", what));
}

inline void check_finite(Vec3 const& numbers, std::string_view what) {
  if (!is_finite(numbers)) throw std::invalid_argument(fmt::format("{} must be finite", what));
}

}  // namespace lichtraum
