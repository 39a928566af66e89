#pragma once

#include <memory>
#include <vector>

#include "io/gltf/document.hpp"
#include "io/gltf/names.hpp"
#include "lichtraum/material.hpp"

namespace lichtraum::gltf {

/// The model's materials, by their numbers, and behind them the one for primitives that name none.
std::vector<std::shared_ptr<Material>> read_materials(tinygltf::Model const& model, Names& names, Findings& findings);

}  // namespace lichtraum::gltf
