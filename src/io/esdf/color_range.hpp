#pragma once

#include <span>
#include <string_view>

#include "io/esdf/interpreter.hpp"

namespace lichtraum::esdf {

/// The share of light that a surface sends on: 1 is all. Scenes overdrive it a little on purpose.
inline constexpr double largest_share = 10;
/// What falls on a surface from a lamp, which may be many times as bright as white.
inline constexpr double no_largest_share = 0;

/// Warns where a color is negative or looks as if white were 255 255 255: the three values of `tokens`. `what` starts
/// the message. `largest`: values beyond look so; `no_largest_share` for light, where only whole numbers up to 255 do.
/// False after a warning.
bool check_color(Interpreter& interpreter, std::span<Token const> tokens, std::span<double const> values,
                 std::string_view what, double largest);

}  // namespace lichtraum::esdf
