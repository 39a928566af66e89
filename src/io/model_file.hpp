#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "lichtraum/file_stamp.hpp"

namespace lichtraum {

/// Reads a file that a model names: a regular one in `folder`, below it, or in one of the allowed folders; none where
/// the model has no folder. Nothing when it may not or cannot be read; `reason` then says why.
std::optional<std::string> read_model_file(std::optional<std::filesystem::path> const& folder,
                                           std::span<std::filesystem::path const> allowed, FileObserver const& on_read,
                                           std::string const& name, std::string& reason);

}  // namespace lichtraum
