#include "compile/light_table.hpp"

#include <glm/geometric.hpp>

#include "scene/device_light.hpp"

namespace lichtraum {
namespace {

/// Whether rays from the point resolve the scene: their t has 24 bits for all of the distance.
bool is_near(Vec3 const& point, DeviceBounds const& bounds) {
  constexpr double max_distance = 16;  // in diagonals of the scene
  if (bounds.is_empty()) return false;
  Vec3 const min(bounds.min), max(bounds.max);
  return glm::distance(point, 0.5 * (min + max)) <= max_distance * glm::distance(min, max);
}

}  // namespace

BigVector<device::PunctualLight> make_light_table(std::vector<Light> const& lights, DeviceBounds const& world_bounds) {
  BigVector<device::PunctualLight> table;
  for (Light const& light : lights) {
    auto form = device_light(light);
    if (!form) continue;
    form->is_near = light.position() && is_near(*light.position(), world_bounds) ? 1 : 0;
    table.push_back(*form);
  }
  return table;
}

}  // namespace lichtraum
