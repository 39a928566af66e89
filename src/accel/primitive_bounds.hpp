#pragma once

#include "lichtraum/transform.hpp"
#include "scene/device_bounds.hpp"
#include "shared/geometry.h"

namespace lichtraum {

/// The bounds of primitives as the device computes with them: never smaller, up to rounding outwards.
DeviceBounds bounds_of(device::TrianglePrimitive const& triangle);
DeviceBounds bounds_of(device::SpherePrimitive const& sphere);
DeviceBounds bounds_of(device::EllipsoidPrimitive const& ellipsoid);
DeviceBounds bounds_of(device::BoxPrimitive const& box);
DeviceBounds bounds_of(device::CylinderPrimitive const& cylinder);
DeviceBounds bounds_of(device::ConePrimitive const& cone);

/// The bounds of a mapped box. Empty stays empty.
DeviceBounds map_bounds(Transform const& world_from_object, DeviceBounds const& object_bounds);

}  // namespace lichtraum
