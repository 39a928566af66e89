#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "io/gltf/buffers.hpp"
#include "lichtraum/pbr_model.hpp"
#include "scene/texture_lookup.hpp"

namespace lichtraum::gltf {

/// The model's textures, by their numbers; null where no picture can be had. Pictures are decoded once, on all cores.
/// Only those that are used (textures, by number) are, for colours if for those at all.
std::vector<std::shared_ptr<Texture const>> read_textures(Document const& document,
                                                          std::vector<std::optional<TexelContent>> const& used,
                                                          int max_size, Buffers& buffers, Findings& findings);

}  // namespace lichtraum::gltf
