#pragma once

#include <filesystem>
#include <system_error>

namespace lichtraum {

/// Absolute, without "." and "..". An empty name has no such path, nor has a relative one in a folder that was deleted:
/// they stay as they are, and opening them says what is wrong.
inline std::filesystem::path whole_path(std::filesystem::path const& path) {
  std::error_code error;
  std::filesystem::path const absolute = std::filesystem::absolute(path, error);
  return (error ? path : absolute).lexically_normal();
}

}  // namespace lichtraum
