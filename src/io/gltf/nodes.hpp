#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "io/gltf/document.hpp"

namespace lichtraum::gltf {

/// Moves the nodes out of a model that conforms to the schema: what tinygltf would make of them, without their way
/// through text. A model may have a hundred thousand.
std::vector<tinygltf::Node> take_nodes(nlohmann::json& model);

}  // namespace lichtraum::gltf
