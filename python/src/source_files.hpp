#pragma once

#include <filesystem>
#include <set>

namespace lichtraum::python {

/// What a picture is drawn from, which it must not take the place of when it is saved. As that may be long after, these
/// are names, not files: whole ones, behind links.
class SourceFiles {
 public:
  /// What is not there is left out.
  void add(std::filesystem::path const& file);
  void add(SourceFiles const& others) { names_.insert(others.names_.begin(), others.names_.end()); }

  std::set<std::filesystem::path> const& names() const { return names_; }

  /// Throws as app::FilesRead does.
  void refuse_to_overwrite(std::filesystem::path const& output) const;

 private:
  std::set<std::filesystem::path> names_;
};

}  // namespace lichtraum::python
