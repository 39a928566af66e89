#pragma once

#include <string>
#include <vector>

#include "lichtraum/scene.hpp"

namespace lichtraum {

/// A camera in front of `box` (at +z), slightly above, that sees all of it.
Camera frame_box(std::string name, Bounds const& box);

/// What makes a scene without lights readable on first sight: a key light from above and the right of the viewer, a
/// weaker fill light from the left, and a soft ambient one.
std::vector<Light> studio_lights(Bounds const& box);

}  // namespace lichtraum
