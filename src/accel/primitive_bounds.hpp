#pragma once

#include "lichtraum/transform.hpp"
#include "scene/bounds.hpp"
#include "shared/geometry.h"

namespace lichtraum {

/// The bounds of primitives as the device computes with them: never smaller, up to rounding outwards.
Bounds bounds_of(device::TrianglePrimitive const& triangle);
Bounds bounds_of(device::SpherePrimitive const& sphere);
Bounds bounds_of(device::EllipsoidPrimitive const& ellipsoid);
Bounds bounds_of(device::BoxPrimitive const& box);

/// The bounds of a mapped box. Empty stays empty.
Bounds map_bounds(Transform const& world_from_object, Bounds const& object_bounds);

}  // namespace lichtraum
