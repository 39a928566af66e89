#include "view/edited_number.hpp"

#include <fmt/format.h>

#include "core/parse_number.hpp"

namespace lichtraum::view {

double edited_number(double number, float shown) {
  return float(number) == shown ? number : parse_number(fmt::format("{}", shown)).value;
}

}  // namespace lichtraum::view
