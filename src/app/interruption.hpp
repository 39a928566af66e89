#pragma once

namespace lichtraum::app {

/// Lets SIGINT and SIGTERM end the process with status 130: at once, or, while a GracefulScope exists, by asking.
/// Writing to a closed pipe or past a file size limit becomes an error code instead of a signal.
void handle_signals();

/// While one exists, the first SIGINT or SIGTERM only makes `interrupted` true; a second one still ends the process.
class GracefulScope {
 public:
  GracefulScope();
  ~GracefulScope();
  GracefulScope(GracefulScope const&) = delete;
  GracefulScope& operator=(GracefulScope const&) = delete;
};

bool interrupted();

}  // namespace lichtraum::app
