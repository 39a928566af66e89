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

double rest_of(double share) {
  constexpr double places = 1e12;  // more than what is typed or shown has
  double const rest = std::round((1 - share) * places) / places;
  return share + rest > 1 ? 1 - share : rest;
}

}  // namespace lichtraum::view
