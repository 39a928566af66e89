#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "lichtraum/file_stamp.hpp"

namespace lichtraum {

/// Where a file is that a model names: a regular one in `folder`, below it, or in one of the allowed folders; none
/// where the model has no folder. Nothing when it may not be read; `reason` then says why. The path is the same however
/// the file is named.
std::optional<std::filesystem::path> find_model_file(std::optional<std::filesystem::path> const& folder,
                                                     std::span<std::filesystem::path const> allowed,
                                                     FileObserver const& on_read, std::string const& name,
                                                     std::string& reason);

/// Reads what find_model_file gives. Nothing when it cannot be read; `reason` then says why.
std::optional<std::string> read_found_file(std::filesystem::path const& path, std::string& reason);

/// Both.
std::optional<std::string> read_model_file(std::optional<std::filesystem::path> const& folder,
                                           std::span<std::filesystem::path const> allowed, FileObserver const& on_read,
                                           std::string const& name, std::string& reason);

/// What helps where read_model_file refuses a file for its place; empty where nothing does. `whose`: the folder.
std::string hint_for_place(std::optional<std::filesystem::path> const& folder,
                           std::span<std::filesystem::path const> allowed, std::string const& name,
                           std::string_view whose = "model's");

}  // namespace lichtraum
