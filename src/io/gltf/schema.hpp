#pragma once

#include <nlohmann/json_fwd.hpp>

#include "io/gltf/findings.hpp"

namespace lichtraum::gltf {

/// Makes `model` one that holds only what the importer knows, each property of the type and range that glTF 2.0 gives
/// it: afterwards every index is within its list. What is wrong is left out with a warning; an element that makes no
/// sense without it is replaced by one that draws nothing, so that the indices of the others stay what they are. Fails
/// when `model` is not a glTF 2 asset at all.
void conform_to_schema(nlohmann::json& model, Findings& findings);

}  // namespace lichtraum::gltf
