#pragma once

#include <string>
#include <string_view>

#include "io/gltf/document.hpp"

namespace lichtraum::gltf {

/// EXT_meshopt_compression, KHR_meshopt_compression: decodes `compressed` as the extension's object says.
/// Returns the bytes, or why there are none in `reason` (then the result is empty).
std::string decode_meshopt(tinygltf::Value const& parameters, std::string_view compressed, std::string& reason);

}  // namespace lichtraum::gltf
