#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "lichtraum/pbr_model.hpp"

namespace lichtraum {

/// Decodes a PNG, JPEG or WebP, whichever the bytes are, and halves it until no side is longer than `max_size`. What is
/// larger than 2^26 pixels is refused before it is decoded. Says why in `reason` when there is no picture.
std::optional<TextureImage> decode_image(std::string_view bytes, int max_size, std::string& reason);

/// What that picture takes in memory, by its header; 0 where there will be none.
std::uint64_t decoded_bytes(std::string_view bytes, int max_size);

}  // namespace lichtraum
