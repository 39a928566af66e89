#pragma once

#include "accel/bvh.hpp"
#include "shared/wide.h"

namespace lichtraum {

/// Leaves that become blocks, by what they hold.
struct BlockCounts {
  device::uint triangles = 0;
  device::uint spheres = 0;

  void add(BlockCounts const& other) {
    triangles += other.triangles;
    spheres += other.spheres;
  }
};
BlockCounts blocks_in(Bvh const& bvh, device::BvhChild const& leaf);

/// What becomes of a node of the binary tree when it is collapsed to WIDE_CHILDREN children a node.
class CollapsePlan {
 public:
  /// In the subtree that begins here, when the node begins a wide one.
  device::uint wide_nodes = 0;
  BlockCounts blocks;  ///< below

  /// Where the subtree may become n children of a wide node, its left child gets so many of them. 0: it stays one.
  std::size_t share_of_left(std::size_t n) const { return std::size_t(shares_ >> shift(n) & 15); }
  void set_share_of_left(std::size_t n, std::size_t share) { shares_ |= std::uint64_t(share) << shift(n); }

 private:
  static_assert(WIDE_CHILDREN == 16);
  static std::size_t shift(std::size_t n) { return 4 * (n % WIDE_CHILDREN); }

  std::uint64_t shares_ = 0;  ///< four bits for each n; a share of all 16 is in the place of n = 0
};

/// The plan of least cost for each node: of all ways to collapse the tree, the one whose wide nodes have the least
/// surface in sum (dynamic programming as in Ylitie, Karras and Laine, "Efficient Incoherent Ray Traversal on GPUs
/// Through Compressed Wide BVHs", 2017, section 3.1). Leaves cost nothing, as they are the same whatever the nodes
/// above them. On every core; the same whatever their number. The root must have two children.
BigVector<CollapsePlan> plan_collapse(Bvh const& bvh);

}  // namespace lichtraum
