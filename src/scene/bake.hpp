#pragma once

#include "lichtraum/shapes.hpp"
#include "scene/flat_scene.hpp"

namespace lichtraum {

/// Appends the leaf `shape` to `object`. `object_from_shape` is the whole way from the leaf's own frame, the leaf's own
/// transform included. Spheres stay exact spheres under similarities and become ellipsoids otherwise; boxes keep a
/// matrix; triangles keep their outward side under mirroring. Returns how many primitives were left out because a
/// coordinate does not fit a float.
std::uint64_t bake(Shape const& shape, Transform const& object_from_shape, device::PrimitiveTag tag,
                   FlatObject& object);

}  // namespace lichtraum
