#pragma once

#include <map>
#include <optional>
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

/// An attribute to be taken out of it.
struct DracoAttribute {
  int id = -1;  ///< the extension's own
  /// Whether integers are fractions of their largest value: what the accessor says. The compressed data has a flag of
  /// its own, which counts where there is no accessor.
  std::optional<bool> is_normalized;
};

/// `attributes`: by their names. What is wrong with the data goes to `reason`; then there is no result.
std::optional<DracoPrimitive> decode_draco(std::string_view compressed,
                                           std::map<std::string, DracoAttribute> const& attributes,
                                           std::string& reason);

}  // namespace lichtraum::gltf
