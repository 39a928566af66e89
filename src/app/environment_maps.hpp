#pragma once

#include <mutex>
#include <optional>
#include <string>

#include "lichtraum/environment.hpp"
#include "lichtraum/file_stamp.hpp"

namespace lichtraum::app {

/// The environment's map that was asked for last, for several scenes: read again when its file has changed. Any thread
/// may ask.
class EnvironmentMaps {
 public:
  /// Exceptions as environment_map. `on_read` may be empty.
  std::shared_ptr<EnvironmentMap const> find(std::string const& source, FileObserver const& on_read);

 private:
  std::mutex mutex_;
  std::string source_;
  std::optional<FileStamp> stamp_;  // nothing for the built-in one
  std::shared_ptr<EnvironmentMap const> map_;
};

}  // namespace lichtraum::app
