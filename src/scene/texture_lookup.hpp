#pragma once

#include "lichtraum/pbr_model.hpp"

namespace lichtraum {

enum class TexelContent {
  color,  ///< red, green and blue are sRGB; the result is linear
  data,
};

/// What a slot that is not empty shows at a texture coordinate, by its transform, wrap modes and filter: the definition
/// of kernels/shading/texture.clh.
glm::dvec4 look_up(TextureSlot const& slot, glm::dvec2 const& uv, TexelContent content);

/// Where in its picture a slot looks (KHR_texture_transform).
glm::dvec2 transform_coordinate(TextureSlot const& slot, glm::dvec2 const& uv);

}  // namespace lichtraum
