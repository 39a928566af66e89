#pragma once

#include "lichtraum/api.hpp"

namespace LICHTRAUM_API lichtraum {

/// How a scene's primitives are sorted for rays to find.
enum class TreeLayout {
  binary,  ///< two children a node: plain, and for GPUs
  wide,    ///< sixteen children a node, triangles and spheres in blocks of four: for CPUs
};

/// Which rays go together.
enum class RayGrouping {
  one,     ///< each by itself, a pixel after the other
  stream,  ///< a few of a square of pixels interleaved, and what they hit is shaded sixteen at once
  packet,  ///< the same, but camera rays, and shadow rays from a point light near by, as packets of one origin
};

/// How rays find what they hit. The picture is the same, but for single pixels at the edges of shadows and where
/// surfaces meet; the time is not. `one` goes with the binary tree, the others with the wide one.
struct Traversal {
  TreeLayout layout = TreeLayout::binary;
  RayGrouping grouping = RayGrouping::one;
  friend bool operator==(Traversal const&, Traversal const&) = default;

  static Traversal const scalar;  ///< binary, one: the default but on CPUs
  static Traversal const wide;    ///< wide, stream
  static Traversal const packet;  ///< wide, packet: the default on CPUs
};

inline constexpr Traversal Traversal::scalar{TreeLayout::binary, RayGrouping::one};
inline constexpr Traversal Traversal::wide{TreeLayout::wide, RayGrouping::stream};
inline constexpr Traversal Traversal::packet{TreeLayout::wide, RayGrouping::packet};

}  // namespace lichtraum
