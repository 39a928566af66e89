#pragma once

#include <string_view>

#include "lichtraum/scene.hpp"

namespace lichtraum {

/// The middle of what is looked at: of the box around all shapes (or what is below the one called `root`) that do not
/// surround the camera, as a floor beneath it and a room around it do. When all of them do, of the box around
/// everything; the world's origin when nothing is drawn. Throws Error{usage} for an unknown root.
Vec3 center_of_interest(Scene const& scene, std::string_view root, Camera const& camera);

/// The camera carried around the vertical line through `center`, counterclockwise as seen from above; it keeps looking
/// at it as it did.
Camera orbited(Camera const& camera, Vec3 const& center, double degrees);

}  // namespace lichtraum
