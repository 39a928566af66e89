#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>

namespace lichtraum::app {

/// Lets SIGINT and SIGTERM end the process with status 130: at once, or, while a GracefulScope exists, by asking.
/// Writing to a closed pipe or past a file size limit becomes an error code instead of a signal.
void handle_signals();

/// While one exists, the first SIGINT or SIGTERM only makes `interrupted` true; one that comes half a second
/// later or more still ends the process.
class GracefulScope {
 public:
  GracefulScope();
  ~GracefulScope();
  GracefulScope(GracefulScope const&) = delete;
  GracefulScope& operator=(GracefulScope const&) = delete;
};

bool interrupted();

/// While one exists, a signal that ends this process first removes the file `path`, and before that ends the child
/// `writer` that is writing it, if there is one. One at a time.
class UnfinishedFile {
 public:
  UnfinishedFile(std::optional<pid_t> writer, std::filesystem::path path);
  ~UnfinishedFile();
  UnfinishedFile(UnfinishedFile const&) = delete;
  UnfinishedFile& operator=(UnfinishedFile const&) = delete;

  /// For remove_unfinished_file.
  void remove() const;

 private:
  std::optional<pid_t> writer_;
  std::filesystem::path path_;
};

/// Ends the writer and removes the file, if there is an UnfinishedFile. For handlers of signals and of std::terminate.
void remove_unfinished_file();

}  // namespace lichtraum::app
