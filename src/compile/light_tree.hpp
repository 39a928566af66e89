#pragma once

#include <vector>

#include "core/big_vector.hpp"
#include "lichtraum/bounds.hpp"
#include "shared/light.h"

namespace lichtraum {

/// A light as a light tree knows it.
struct LightLeaf {
  Bounds bounds;            ///< world
  Vec3 normal = Vec3(0);    ///< unit, of a flat one, which shines to both sides; 0: it shines alike all around
  double intensity = 0;     ///< where it is brightest, in any unit that all have; > 0
  device::uint number = 0;  ///< the kernels' for it
};

/// What lights/light_tree.clh descends; the root is node 0. There must be a leaf. `diagonal`: the scene's, > 0.
BigVector<device::LightTreeNode> make_light_tree(std::vector<LightLeaf> leaves, double diagonal);

}  // namespace lichtraum
