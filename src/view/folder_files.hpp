#pragma once

#include <filesystem>
#include <optional>

namespace lichtraum::view {

/// The file that is shown, and the way through the others of its folder: those with the extension of a scene or of a
/// model, in the order of the numbers in their names, the first after the last.
class FolderFiles {
 public:
  explicit FolderFiles(std::filesystem::path file) : file_(std::move(file)) {}

  std::filesystem::path const& file() const { return file_; }
  /// A file from elsewhere.
  void open(std::filesystem::path const& file);
  /// The next file (1) or the previous one (-1), which is to be opened now; nothing where there is no other.
  std::optional<std::filesystem::path> step(int direction);
  /// The file that was asked for last cannot be read: the one to try instead. After a step, those behind it, until it
  /// is where it began; nothing where there is no more to try.
  std::optional<std::filesystem::path> skip();
  /// It could be read.
  void arrive() { direction_ = 0; }

 private:
  std::filesystem::path file_;
  std::filesystem::path start_;  // of the step
  int direction_ = 0;            // of a step that has found nothing yet
};

}  // namespace lichtraum::view
