#pragma once

#include <functional>
#include <memory>
#include <unordered_map>
#include <vector>

#include "lichtraum/shapes.hpp"

namespace lichtraum {

/// Of a shape that is copied, the material that its copy gets.
using MaterialChoice = std::function<std::shared_ptr<Material const>(Shape const&)>;

/// The same graph from new nodes: what changes in the old one later does not show in it. Meshes share their geometry,
/// shapes their materials unless another is chosen; what was shared within the graph still is. Without recursion.
std::vector<std::shared_ptr<Shape>> copy_graph(
    std::vector<std::shared_ptr<Shape const>> const& roots,
    MaterialChoice const& material_of = [](Shape const& shape) { return shape.material(); });

/// With other values for some of the materials.
std::vector<std::shared_ptr<Shape>> copy_graph(std::vector<std::shared_ptr<Shape const>> const& roots,
                                               std::unordered_map<Material const*, Material> const& replaced_materials);

}  // namespace lichtraum
