#include "view/edited_number.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/largest_radiance.hpp"
#include "core/parse_number.hpp"

namespace lichtraum::view {

double edited_number(double number, float shown) {
  bool const stays = float(number) == shown || !std::isfinite(shown);
  return stays ? number : parse_number(fmt::format("{}", shown)).value;
}

double edited_channel(double channel, float shown) {
  double const edited = edited_number(channel, shown);
  return edited == channel ? channel : std::clamp(edited, 0.0, largest_radiance);
}

}  // namespace lichtraum::view
