#include "reference/environment.hpp"

#include <cmath>
#include <numbers>

#include "core/elementary.hpp"
#include "lichtraum/orbit.hpp"

namespace lichtraum {

ReferenceEnvironment::ReferenceEnvironment(EnvironmentLight light, Vec3 const& up)
    : light_(std::move(light)), map_from_world_(orbit_rotation({light_.rotation_degrees, 0}, up).inverse()) {
  north_ = mean_of_row(0);
  south_ = mean_of_row(light_.map->height - 1);
}

Rgb ReferenceEnvironment::texel(int row, int column) const {
  int const width = light_.map->width;
  std::size_t const place = 3 * (std::size_t(row) * std::size_t(width) + std::size_t((column + width) % width));
  float const* const color = &light_.map->radiance[place];
  return {color[0], color[1], color[2]};
}

Rgb ReferenceEnvironment::mean_of_row(int row) const {
  Rgb sum(0);
  for (int column = 0; column < light_.map->width; ++column) sum += texel(row, column);
  return sum / double(light_.map->width);
}

/// Between the middles of texels, which lie at whole numbers; beyond the first and the last row, at the pole.
Rgb ReferenceEnvironment::value(int row, double column) const {
  if (row < 0) return north_;
  if (row >= light_.map->height) return south_;
  int const left = int(std::floor(column));
  return glm::mix(texel(row, left), texel(row, left + 1), column - left);
}

Rgb ReferenceEnvironment::radiance(Vec3 const& direction) const {
  if (!light_.map) return Rgb(0);
  Vec3 const in_map = map_from_world_.vector(direction);
  double const u = 0.5 + atan2_of(in_map.z, in_map.x) / (2 * std::numbers::pi);
  double const v = atan2_of(std::sqrt(in_map.x * in_map.x + in_map.z * in_map.z), in_map.y) / std::numbers::pi;
  double const column = u * light_.map->width - 0.5;
  double const row = v * light_.map->height - 0.5;
  int const upper = int(std::floor(row));
  // The poles lie half a texel from the middles of the rows beside them.
  bool const is_near_pole = upper < 0 || upper + 1 >= light_.map->height;
  double const share = upper < 0 ? 2 * (row + 0.5) : is_near_pole ? 2 * (row - upper) : row - upper;
  return light_.brightness * glm::mix(value(upper, column), value(upper + 1, column), share);
}

}  // namespace lichtraum
