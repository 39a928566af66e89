#pragma once

#include <filesystem>
#include <optional>

namespace lichtraum {

/// Where a write through symbolic links ends up, the last of them dangling or not. Nothing when there are too many.
std::optional<std::filesystem::path> follow_links(std::filesystem::path const& path);

}  // namespace lichtraum
