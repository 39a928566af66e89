#pragma once

#include <span>
#include <vector>

#include "accel/bvh.hpp"
#include "shared/geometry.h"
#include "shared/vertex.h"
#include "shared/wide.h"

namespace lichtraum {

/// The hierarchy of one object with sixteen children a node. nodes[0] is the root.
struct WideBvh {
  std::vector<device::WideNode> nodes;
  /// Which references share a block: references[first, first + count) of the binary hierarchy.
  struct Block {
    device::uint first = 0;
    device::uint count = 0;
  };
  std::vector<Block> triangle_blocks;
  std::vector<Block> sphere_blocks;
  /// The entries that a traversal's stack needs for this tree: it visits one child and keeps the others.
  std::size_t stack_size = 0;
};

/// Collapses a binary hierarchy: a wide node takes the place of up to fifteen binary ones. Of all ways to do so, the
/// one whose nodes have the least surface in sum (dynamic programming as in Ylitie, Karras and Laine, "Efficient
/// Incoherent Ray Traversal on GPUs Through Compressed Wide BVHs", 2017, section 3.1). Subtrees of at most four
/// triangles, or four spheres, become one block. A leaf child's index is that of the block among those of its kind, or
/// the primitive's own (see shared/wide.h). Nodes lie in depth-first order, blocks in the order of the binary tree's
/// leaves. The same result
/// whatever the number of threads.
WideBvh collapse(Bvh const& bvh);

/// Gathers the triangles of blocks.
void fill_triangle_blocks(std::span<WideBvh::Block const> blocks,
                          std::span<device::PrimitiveReference const> references,
                          std::span<device::TrianglePrimitive const> triangles, std::span<device::TriangleBlock> filled,
                          std::span<device::PrimitiveTag> tags);

/// The same of what their vertices have; triangles beyond the end of `attributes` have nothing.
void fill_block_attributes(std::span<WideBvh::Block const> blocks,
                           std::span<device::PrimitiveReference const> references,
                           std::span<device::TriangleAttributes const> attributes,
                           std::span<device::TriangleAttributes> filled);

/// Gathers the spheres of blocks.
void fill_sphere_blocks(std::span<WideBvh::Block const> blocks, std::span<device::PrimitiveReference const> references,
                        std::span<device::SpherePrimitive const> spheres, std::span<device::SphereBlock> filled);

}  // namespace lichtraum
