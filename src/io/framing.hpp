#pragma once

#include <memory>
#include <vector>

#include "lichtraum/scene.hpp"

namespace lichtraum {

/// An axis-parallel box in the world; min > max when nothing is in it.
struct WorldBox {
  Vec3 min;
  Vec3 max;
  bool is_empty() const { return !(min.x <= max.x && min.y <= max.y && min.z <= max.z); }
};

/// Around all that `roots` draw: exact for what is not rotated, and never too small. Linear in the size of the graph.
WorldBox bounds_of(std::vector<std::shared_ptr<Shape const>> const& roots);

/// A camera in front of `box` (at +z), slightly above, that sees all of it.
Camera frame_box(std::string name, WorldBox const& box);

/// What makes a scene without lights readable on first sight: a key light from above and the right of the viewer, a
/// weaker fill light from the left, and a soft ambient one.
std::vector<Light> studio_lights(WorldBox const& box);

}  // namespace lichtraum
