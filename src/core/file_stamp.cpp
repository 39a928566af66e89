#include "lichtraum/file_stamp.hpp"

namespace lichtraum {

std::optional<FileStamp> stamp_of(std::filesystem::path const& path) {
  std::error_code error;
  FileStamp stamp;
  stamp.time = std::filesystem::last_write_time(path, error);
  if (error) return std::nullopt;
  stamp.size = std::filesystem::file_size(path, error);
  if (error) return std::nullopt;
  return stamp;
}

}  // namespace lichtraum
