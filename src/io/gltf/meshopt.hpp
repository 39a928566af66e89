#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "io/gltf/document.hpp"

namespace lichtraum::gltf {

/// EXT_meshopt_compression, KHR_meshopt_compression: decodes `compressed` as the extension's object says.
/// Returns the bytes, or why there are none in `reason` (then the result is empty). `take` is told how many there will
/// be before they take memory; it throws where that is too much.
std::string decode_meshopt(tinygltf::Value const& parameters, std::string_view compressed,
                           std::function<void(std::uint64_t)> const& take, std::string& reason);

}  // namespace lichtraum::gltf
