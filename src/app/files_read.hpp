#pragma once

#include <sys/types.h>

#include <filesystem>
#include <set>
#include <utility>

namespace lichtraum::app {

/// The files that a scene was read from, by what they are, not by their names: so that no picture takes their place.
class FilesRead {
 public:
  /// What is not there, or is no ordinary file, is left out.
  void add(std::filesystem::path const& file);

  /// Throws Error{cannot_create} when `output` is one of them, or a link to one.
  void refuse_to_overwrite(std::filesystem::path const& output) const;

 private:
  std::set<std::pair<dev_t, ino_t>> files_;
};

}  // namespace lichtraum::app
