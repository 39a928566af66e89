#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/loaded_scene.hpp"

namespace lichtraum::app {

/// A scene that the command line names: a file, or "-" for standard input. It can be loaded more than once.
class SceneSource {
 public:
  /// Reads standard input to its end for "-". Throws Error{io}.
  explicit SceneSource(std::string argument);

  /// For messages: the file as given, or "<stdin>".
  std::string const& name() const { return name_; }
  /// The file's name without folder and extension, or "stdin": what a picture is called when nothing else says.
  std::string stem() const;

  /// The job for this scene: `common` with its name. The text of standard input stays here.
  Job job(Job common) const {
    common.scene = name_;
    return common;
  }

  /// With the environment that `reading` chooses. Same exceptions as EsdfScript::from_file, import_model and
  /// environment_map.
  LoadedScene load(SceneReading const& reading, LoadOptions const& options = {}) const;

 private:
  std::string name_;
  std::optional<std::string> text_;  // of standard input
};

}  // namespace lichtraum::app
