#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "io/gltf/accessors.hpp"

namespace lichtraum::gltf {

/// A primitive out of KHR_draco_mesh_compression.
struct DracoPrimitive {
  std::vector<std::uint32_t> indices;  ///< three per triangle
  std::map<std::string, FloatElements> attributes;
};

/// `attribute_ids`: the extension's own, by the attributes' names. What is wrong with the data goes to `reason`; then
/// there is no result.
std::optional<DracoPrimitive> decode_draco(std::string_view compressed, std::map<std::string, int> const& attribute_ids,
                                           std::string& reason);

}  // namespace lichtraum::gltf
