#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>

#include "lichtraum/api.hpp"

namespace LICHTRAUM_API lichtraum {

/// By which one sees that a file has changed.
struct FileStamp {
  std::filesystem::file_time_type time;  ///< when it was written last
  std::uintmax_t size = 0;               ///< bytes
  friend bool operator==(FileStamp const&, FileStamp const&) = default;
};

/// Nothing when there is no such file.
std::optional<FileStamp> stamp_of(std::filesystem::path const& path);

/// Told of each file that is about to be read, also of those that then turn out to be missing.
using FileObserver = std::function<void(std::filesystem::path const&)>;

}  // namespace lichtraum
