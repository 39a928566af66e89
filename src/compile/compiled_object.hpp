#pragma once

#include <array>
#include <cstdint>

#include "core/content_hash.hpp"
#include "scene/device_bounds.hpp"
#include "shared/geometry.h"

namespace lichtraum {

struct PrimitiveRange {
  std::size_t first = 0;
  std::size_t count = 0;
};
/// By PRIMITIVE_...; that of instances is empty.
using PrimitiveRanges = std::array<PrimitiveRange, PRIMITIVE_PLANE + 1>;

/// One object's part of the arrays, so that a later scene in which it is the same can have it.
struct CompiledObject {
  ContentHash content;         ///< of its primitives, and where they begin in the arrays of their kinds
  device::uint root_node = 0;  ///< where its nodes begin, in `nodes` or `wide_nodes`
  device::uint node_count = 0;
  device::uint first_leaf = 0;  ///< where its `references` or `triangle_blocks` begin
  device::uint leaf_count = 0;
  device::uint first_sphere_block = 0;  ///< where its `sphere_blocks` begin
  device::uint sphere_block_count = 0;
  PrimitiveRanges ranges;             ///< where its primitives are, before the layout orders triangles and spheres
  DeviceBounds bounds;                ///< of what has an end
  bool is_unbounded = false;          ///< something has none
  std::size_t stack_size = 0;         ///< that a traversal of it and its instances needs; for the wide layout
  double crowding = 0;                ///< see accel/crowding.hpp
  std::uint64_t unrepresentable = 0;  ///< of its primitives, whose bounds do not fit a float
};

}  // namespace lichtraum
