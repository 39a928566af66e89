#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace lichtraum {

/// A model in a format that is well known, but not read here.
struct UnreadModel {
  std::string what;  ///< "a USD scene, which lichtraum does not read"
  std::string hint;  ///< what makes a model of it that is read
};

/// What a file is by its first bytes, or else by its extension; nothing when it may be anything else.
std::optional<UnreadModel> recognise_unread_model(std::filesystem::path const& path, std::string_view bytes = {});

}  // namespace lichtraum
