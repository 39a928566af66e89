#pragma once

#include <span>

#include "accel/bvh.hpp"
#include "shared/geometry.h"
#include "shared/vertex.h"
#include "shared/wide.h"

namespace lichtraum {

/// The hierarchy of one object with sixteen children a node. nodes[0] is the root.
struct WideBvh {
  BigVector<device::WideNode> nodes;
  /// Which references share a block: references[first, first + count) of the binary hierarchy.
  struct Block {
    device::uint first = 0;
    device::uint count = 0;
  };
  BigVector<Block> triangle_blocks;
  BigVector<Block> sphere_blocks;
  /// The entries that a traversal's stack needs for this tree: it visits one child and keeps the others. With those for
  /// what its instances place.
  std::size_t stack_size = 0;
};

/// Collapses a binary hierarchy: a wide node takes the place of up to fifteen binary ones, as accel/collapse_plan.hpp
/// plans it. A leaf of triangles or spheres becomes a block. A leaf child's index is that of the block among those of
/// its kind, or the primitive's own (see shared/wide.h). Nodes lie in depth-first order, and so do blocks: those of a
/// node next to each other. The same result whatever the number of threads. `stack_sizes_of_instances`: of the objects
/// that they place, by their number in the references.
WideBvh collapse(Bvh const& bvh, std::span<std::size_t const> stack_sizes_of_instances = {});

/// Gathers the triangles of blocks.
void fill_triangle_blocks(std::span<WideBvh::Block const> blocks,
                          std::span<device::PrimitiveReference const> references,
                          std::span<device::TrianglePrimitive const> triangles, std::span<device::TriangleBlock> filled,
                          std::span<device::PrimitiveTag> tags);

/// The same of what is known of each triangle, or sphere; of those beyond the end of `attributes`, nothing.
template <class Attributes>
void fill_block_attributes(std::span<WideBvh::Block const> blocks,
                           std::span<device::PrimitiveReference const> references,
                           BigVector<Attributes> const& attributes, std::span<Attributes> filled) {
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    for (device::uint lane = 0; lane < blocks[b].count; ++lane) {
      device::uint const primitive = references[blocks[b].first + lane].index;
      if (primitive < attributes.size()) filled[b * BLOCK_LANES + lane] = attributes[primitive];
    }
  }
}

/// Gathers the spheres of blocks.
void fill_sphere_blocks(std::span<WideBvh::Block const> blocks, std::span<device::PrimitiveReference const> references,
                        std::span<device::SpherePrimitive const> spheres, std::span<device::SphereBlock> filled);

}  // namespace lichtraum
