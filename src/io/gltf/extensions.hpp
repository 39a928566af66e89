#pragma once

#include <span>
#include <string_view>

namespace lichtraum::gltf {

/// What the importer does with an extension.
struct Extension {
  std::string_view name;
  std::string_view support;  ///< one line for people: docs/GLTF.md holds the same table
};

/// Every extension that the importer reads.
std::span<Extension const> supported_extensions();
/// That of this name, or nullptr.
Extension const* find_extension_support(std::string_view name);
inline bool is_supported_extension(std::string_view name) { return find_extension_support(name) != nullptr; }

}  // namespace lichtraum::gltf
