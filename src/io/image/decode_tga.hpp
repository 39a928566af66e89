#pragma once

#include <string>
#include <string_view>

#include "io/image/decode.hpp"

namespace lichtraum {

// Truevision's TGA File Format Specification, version 2.0: colours, greys and palettes, also with run lengths.

/// Whether bytes begin like one of these. There is no signature, but few other files have a header that makes sense.
bool is_tga(std::string_view bytes);

/// By the header; the bytes must be those of a TGA.
ImageSize size_of_tga(std::string_view bytes);

/// Decodes a TGA into `image`, which has the size of the header. An alpha that is 0 everywhere is none, as many
/// programs leave it so. False, with a reason, for what is damaged or cut off.
bool decode_tga(std::string_view bytes, TextureImage& image, std::string& reason);

}  // namespace lichtraum
