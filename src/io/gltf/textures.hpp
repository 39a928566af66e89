#pragma once

#include <memory>
#include <vector>

#include "io/gltf/buffers.hpp"
#include "lichtraum/pbr_model.hpp"

namespace lichtraum::gltf {

/// The model's textures, by their numbers; null where no picture can be had. Pictures are decoded once, on all cores.
/// Only those that are `wanted` (textures, by number) are.
std::vector<std::shared_ptr<Texture const>> read_textures(Document const& document, std::vector<bool> const& wanted,
                                                          int max_size, Buffers& buffers, Findings& findings);

}  // namespace lichtraum::gltf
