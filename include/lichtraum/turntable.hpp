#pragma once

#include <string_view>

#include "lichtraum/api.hpp"
#include "lichtraum/scene.hpp"

namespace LICHTRAUM_API lichtraum {

/// The box around what is looked at: all shapes (or what is below the one called `root`) that do not surround the
/// camera, as a floor beneath it and a room around it do. When all of them do, the box around everything; empty when
/// nothing is drawn. Throws Error{usage} for an unknown root.
Bounds bounds_of_interest(Scene const& scene, std::string_view root, Camera const& camera);

/// The same before a camera stands anywhere: without what surrounds everything else, at least one and a half times as
/// wide, as a floor (which is flat) or as a room. Of several around each other, all are left out.
Bounds bounds_of_interest(Scene const& scene, std::string_view root);

/// The middle of that box; the world's origin when nothing is drawn.
Vec3 center_of_interest(Scene const& scene, std::string_view root, Camera const& camera);

/// The camera carried around the line through `center` along `up`, counterclockwise as seen from above; it keeps
/// looking at it as it did.
Camera orbited(Camera const& camera, Vec3 const& center, double degrees, Vec3 const& up = {0, 1, 0});

}  // namespace lichtraum
