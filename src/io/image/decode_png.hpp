#pragma once

#include <string>
#include <string_view>

#include "lichtraum/pbr_model.hpp"

namespace lichtraum {

/// Decodes a PNG into `image`, which has the size already that its header is to say. The numbers stay as the file has
/// them: neither gAMA nor a profile changes them (glTF 2.0, 3.8.3), and of 16 bits the upper eight count, rounded.
/// False, with a reason, for what is damaged or cut off.
bool decode_png(std::string_view bytes, TextureImage& image, std::string& reason);

}  // namespace lichtraum
