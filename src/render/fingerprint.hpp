#pragma once

#include <string>

#include "core/content_hash.hpp"
#include "render/scene_shading.hpp"

namespace lichtraum {

/// Of PreparedScene. `content`: of the compiled scene.
std::string scene_fingerprint(ContentHash const& content, SceneShading const& shading);

}  // namespace lichtraum
