#include "view/edited_number.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/parse_number.hpp"

namespace lichtraum::view {

double edited_number(double number, float shown) {
  bool const stays = float(number) == shown || !std::isfinite(shown);
  return stays ? number : parse_number(fmt::format("{}", shown)).value;
}

}  // namespace lichtraum::view
