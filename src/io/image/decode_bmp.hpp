#pragma once

#include <string>
#include <string_view>

#include "io/image/decode.hpp"

namespace lichtraum {

// Windows' bitmaps, as the BITMAPINFOHEADER of Microsoft's documentation and its relatives describe them: 1 to 32 bits
// a pixel, in palettes, colours and masks.

bool is_bmp(std::string_view bytes);

/// By the header; 0 x 0 where that is cut off or none that is known.
ImageSize size_of_bmp(std::string_view bytes);

/// Decodes a bitmap into `image`, which has the size of the header. An alpha that is 0 everywhere is none, as the bytes
/// that may hold it are often left so. False, with a reason, for what is damaged, cut off or compressed.
bool decode_bmp(std::string_view bytes, TextureImage& image, std::string& reason);

}  // namespace lichtraum
