#pragma once

#include <map>
#include <optional>

#include "lichtraum/file_stamp.hpp"

namespace lichtraum::view {

/// The files that a scene was read from, and whether one of them is another than when it was read.
class FileWatch {
 public:
  /// To be called before the file is read, so that no change goes unnoticed.
  void add(std::filesystem::path const& file) { stamps_.try_emplace(file, stamp_of(file)); }

  /// One that has vanished does not count: an editor may be about to rename its successor.
  bool has_changed() const {
    for (auto const& [file, stamp] : stamps_) {
      auto const now = stamp_of(file);
      if (now && now != stamp) return true;
    }
    return false;
  }

 private:
  std::map<std::filesystem::path, std::optional<FileStamp>> stamps_;
};

}  // namespace lichtraum::view
