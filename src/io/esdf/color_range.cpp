#include "io/esdf/color_range.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace lichtraum::esdf {
namespace {

/// In bytes, that is: whole numbers, one at least of the brighter half. A grey of less than 255 is a bright lamp.
bool is_of_bytes(std::span<double const> color) {
  constexpr double half = 128, white = 255;
  auto const [least, most] = std::ranges::minmax(color);
  return std::ranges::all_of(color, [](double v) { return v == std::floor(v); }) && most >= half && most <= white &&
         (least < most || most == white);
}

}  // namespace

bool check_color(Interpreter& interpreter, std::span<Token const> tokens, std::span<double const> values,
                 std::string_view what, double largest) {
  Token const at = span_of(tokens.front(), tokens.back());
  if (std::ranges::min(values) < 0) {
    interpreter.warning(Code::color_out_of_range, at, fmt::format("{} is negative: colours are 0 to 1", what),
                        "0 is black");
    return false;
  }
  if (largest == no_largest_share ? is_of_bytes(values) : std::ranges::max(values) > largest) {
    interpreter.warning(Code::color_out_of_range, at, fmt::format("{} is {}: colours are 0 to 1", what, in_quotes(at)),
                        "1 is full brightness: divide numbers from 0 to 255 by 255");
    return false;
  }
  return true;
}

}  // namespace lichtraum::esdf
