#pragma once

#include <memory>
#include <unordered_map>
#include <vector>

#include "lichtraum/shapes.hpp"

namespace lichtraum {

/// The same graph from new nodes: what changes in the old one later does not show in it. Meshes share their geometry,
/// shapes their materials, except those that are replaced; what was shared within the graph still is. Without
/// recursion.
std::vector<std::shared_ptr<Shape const>> copy_graph(
    std::vector<std::shared_ptr<Shape const>> const& roots,
    std::unordered_map<Material const*, Material> const& replaced_materials = {});

}  // namespace lichtraum
