#pragma once

#include <filesystem>
#include <string_view>

#include "core/descriptor.hpp"

namespace lichtraum {

/// A new file for writing, removed at the end unless it was given another name. Its own name cannot be foreseen: a
/// process of another host may have the same number, and who else may write in the folder could put a link there. It is
/// short, so that a target whose name is as long as names may be can be written too.
class TemporaryFile {
 public:
  /// Its name ends with ".tmp" and the extension. Not open where it cannot be made: errno says why.
  explicit TemporaryFile(std::filesystem::path const& folder, std::string_view extension = "");
  ~TemporaryFile();
  TemporaryFile(TemporaryFile const&) = delete;
  TemporaryFile& operator=(TemporaryFile const&) = delete;

  std::filesystem::path const& path() const { return path_; }
  Descriptor& descriptor() { return descriptor_; }
  /// In the same folder, in place of what is there. Returns errno; 0 when it has that name.
  int rename_to(std::filesystem::path const& target);

 private:
  std::filesystem::path path_;
  Descriptor descriptor_;
  bool is_there_ = false;
};

}  // namespace lichtraum
