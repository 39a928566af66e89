#include "reference/albedo_tables.hpp"

#include <algorithm>
#include <cmath>

#include "shared/ggx_albedo.h"
#include "shared/solid_albedo.h"

namespace lichtraum {
namespace {

/// A place on an axis of a table: between which entries, and how near to the second one.
struct Place {
  int first;
  double share;
};
Place place_on(double x, int entries) {
  double const scaled = std::clamp(x, 0.0, 1.0) * (entries - 1);
  int const first = std::min(int(scaled), entries - 2);
  return {first, scaled - first};
}

/// The mean of the corners' values, weighted by how near they are; `value(i, j)` is called for both ends of two axes.
template <class Value>
double between(Place const& x, Place const& y, Value const& value) {
  double sum = 0;
  for (int i : {0, 1}) {
    for (int j : {0, 1}) {
      sum += (i == 1 ? x.share : 1 - x.share) * (j == 1 ? y.share : 1 - y.share) * value(x.first + i, y.first + j);
    }
  }
  return sum;
}

}  // namespace

ReflectionAlbedo reflection_albedo(double alpha, double cosine) {
  Place const column = place_on(std::sqrt(std::max(cosine, 0.0)), GGX_ALBEDO_SIZE);
  Place const row = place_on(std::sqrt(alpha), GGX_ALBEDO_SIZE);
  auto const channel = [&](int which) {
    return between(column, row, [&](int i, int j) {
      return double(device::ggx_albedo_table[2 * (j * GGX_ALBEDO_SIZE + i) + which]);
    });
  };
  return {channel(0), channel(1)};
}

SolidAlbedo solid_albedo(double eta, double specular, double alpha, double cosine) {
  Place const column = place_on(std::sqrt(std::max(cosine, 0.0)), SOLID_COSINES);
  double const least = double(SOLID_LEAST_ROUGHNESS);
  Place const row = place_on((std::sqrt(alpha) - least) / (1 - least), SOLID_ROUGHNESSES);
  double const ratio = std::abs(eta - 1) / (eta + 1);
  Place const slice = place_on(std::sqrt(ratio / double(SOLID_LARGEST)), SOLID_IORS);
  auto const entry = [&](int which) {
    auto const in_slice = [&](int k) {
      return between(column, row, [&](int i, int j) {
        return double(device::solid_albedo_table[6 * ((k * SOLID_ROUGHNESSES + j) * SOLID_COSINES + i) + which]);
      });
    };
    return (1 - slice.share) * in_slice(slice.first) + slice.share * in_slice(slice.first + 1);
  };
  auto const channel = [&](int first) { return (1 - specular) * entry(first) + specular * entry(first + 1); };
  return {channel(eta > 1 ? 2 : 0), channel(4)};
}

}  // namespace lichtraum
