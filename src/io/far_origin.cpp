#include "io/far_origin.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace lichtraum {
namespace {

constexpr double most = 1000;  // sizes: floats have 24 bits, and 14 are left for what lies within

double largest_of(Vec3 const& v) { return std::max({v.x, v.y, v.z}); }
double size_of(Bounds const& box) { return largest_of(box.max - box.min); }
double farthest_in(Bounds const& box) { return largest_of(glm::max(glm::abs(box.min), glm::abs(box.max))); }

}  // namespace

bool may_be_far(Bounds const& rounded) {
  return !rounded.is_empty() && farthest_in(rounded) > most / 2 * size_of(rounded);
}

std::optional<Vec3> far_origin(Bounds const& box) {
  constexpr double beyond = 1e-14;  // of what doubles tell apart
  if (box.is_empty() || !box.is_finite()) return std::nullopt;
  double const size = size_of(box), farthest = farthest_in(box);
  if (!std::isnormal(size) || farthest <= most * size || size <= beyond * farthest) return std::nullopt;
  double step = 1;  // the power of ten that is not longer
  while (step > size) step /= 10;
  while (10 * step <= size) step *= 10;
  Vec3 origin = box.center();
  for (int i = 0; i < 3; ++i) {
    origin[i] = step < 1 ? std::round(origin[i] * std::round(1 / step)) / std::round(1 / step)
                         : std::round(origin[i] / step) * step;
  }
  return origin + Vec3(0);  // no -0
}

Diagnostic moved_from(Vec3 const& origin, std::string const& file) {
  std::string const place = fmt::format("{} {} {}", origin.x, origin.y, origin.z);
  return {Severity::warning,
          DiagnosticCode::far_from_origin,
          {file, 0, 0},
          1,
          fmt::format("the model lies too far from the origin for its size: moved, so that {} is the origin", place),
          {},
          {}};
}

}  // namespace lichtraum
