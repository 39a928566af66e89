#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "lichtraum/pbr_model.hpp"
#include "scene/texture_lookup.hpp"

namespace lichtraum {

/// Decodes a PNG, JPEG, WebP, BMP or TGA, whichever the bytes are, and halves it until no side is longer than
/// `max_size`: colours by their light. What is larger than 2^26 pixels is refused before it is decoded. Says why in
/// `reason` when there is no picture.
std::optional<TextureImage> decode_image(std::string_view bytes, int max_size, TexelContent content,
                                         std::string& reason);

struct ImageSize {
  std::int64_t width = 0, height = 0;

  std::uint64_t bytes() const { return std::uint64_t(width) * std::uint64_t(height) * 4; }
  std::int64_t longer_side() const { return std::max(width, height); }
  ImageSize halved() const { return {(width + 1) / 2, (height + 1) / 2}; }
  friend bool operator==(ImageSize const&, ImageSize const&) = default;
};

/// The size that such a picture will have, by its header; 0 x 0 where there will be none.
ImageSize decoded_size(std::string_view bytes, int max_size);

}  // namespace lichtraum
