#pragma once

#include <span>

#include "core/big_vector.hpp"
#include "scene/device_bounds.hpp"
#include "shared/bvh.h"

namespace lichtraum {

/// A primitive as the builder sees it.
struct BuildPrimitive {
  DeviceBounds bounds;  ///< finite
  device::PrimitiveReference reference;
};

/// The canonical hierarchy of one object: binary, with its root at nodes[0]. Nodes lie in depth-first order, and each
/// leaf's references next to each other. A leaf has up to four triangles, up to four spheres, or one of anything else;
/// no node but the root has only as much below it as a leaf can hold. Without primitives the root has two absent
/// children.
struct Bvh {
  BigVector<device::BvhNode> nodes;
  BigVector<device::PrimitiveReference> references;
  DeviceBounds bounds;
};

/// Holds nothing.
inline bool is_absent(device::BvhChild const& child) { return !(child.min[0] <= child.max[0]); }

/// Top-down with the surface area heuristic over bins of centroids (Wald 2007, "On fast construction of SAH-based
/// bounding volume hierarchies"), of a sample of them as long as there are many, on every core. The same tree whatever
/// the number of threads; no path of it is longer than BVH_MAX_DEPTH. Takes O(n log n) time for any input, identical
/// primitives included. Reorders its argument.
///
/// `unbounded` is what no box can hold, say a plane, or an instance of what has one. It stands beside the tree, next to
/// the root, where every ray meets it, and so decides nothing about the tree. Of its bounds only Bvh::bounds knows:
/// they are those of what in it is bounded, or empty.
Bvh build_bvh(std::span<BuildPrimitive> primitives, std::span<BuildPrimitive const> unbounded = {});

}  // namespace lichtraum
