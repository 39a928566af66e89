#pragma once

#include <memory>
#include <vector>

#include "lichtraum/shapes.hpp"

namespace lichtraum {

/// The same graph from new nodes: what changes in the old one later does not show in it. Meshes share their geometry,
/// shapes their materials; what was shared within the graph still is. Without recursion.
std::vector<std::shared_ptr<Shape const>> copy_graph(std::vector<std::shared_ptr<Shape const>> const& roots);

}  // namespace lichtraum
