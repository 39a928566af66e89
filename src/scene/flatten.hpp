#pragma once

#include <memory>
#include <vector>

#include "scene/flat_scene.hpp"

namespace lichtraum {

/// Multiplies the matrices down the graph. What occurs once is baked into world space; a composite or a mesh that
/// occurs several times, or a large composite that moves as one, becomes an object with instances. Iterative: the depth
/// of the graph is not limited.
/// Throws Error{scene} with the numbers when the graph unfolds to more than memory can hold.
FlatScene flatten(std::vector<std::shared_ptr<Shape const>> const& roots);

}  // namespace lichtraum
