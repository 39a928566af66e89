#pragma once

#include <memory>
#include <vector>

#include "io/gltf/buffers.hpp"
#include "io/names.hpp"
#include "lichtraum/material.hpp"
#include "lichtraum/model.hpp"

namespace lichtraum::gltf {

/// The model's materials, by their numbers, and after them the one for primitives that name none. Pictures larger than
/// choice.max_texture on a side are made smaller; with choice.both_sides all are double-sided.
std::vector<std::shared_ptr<Material>> read_materials(Document const& document, ModelChoice const& choice,
                                                      Buffers& buffers, Budget& budget, Findings& findings);

}  // namespace lichtraum::gltf
