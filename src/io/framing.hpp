#pragma once

#include <string>
#include <vector>

#include "lichtraum/scene.hpp"

namespace lichtraum {

/// A camera that sees all of `box` in pictures of any proportions: from the side of its front (at +z where +y is up,
/// see orbit_rotation), slightly above.
Camera frame_box(std::string name, Bounds const& box, Vec3 const& up = {0, 1, 0});

/// What makes a scene without lights readable on first sight: a key light from above and the right of a viewer who is
/// at that angle to the right of the front, a weaker fill light from the left, and a soft ambient one.
std::vector<Light> studio_lights(Bounds const& box, double viewer_azimuth_degrees, Vec3 const& up = {0, 1, 0});

}  // namespace lichtraum
