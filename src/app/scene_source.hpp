#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/loaded_scene.hpp"

namespace lichtraum::app {

inline constexpr char const* frames_need_gltf = "--frames is for one animated glTF model";

/// What gives a scene the environment that was chosen, and a model that is drawn by paths a place in the studio. Empty
/// where nothing is to be changed.
std::function<void(Scene&)> scene_adjustment(EnvironmentChoice const& choice, bool is_model,
                                             LoadOptions const& options);

/// A scene that the command line names: a file, or "-" for standard input. It can be loaded more than once.
class SceneSource {
 public:
  /// Reads standard input to its end for "-": `input_format` is "sdf" or one of model_formats(); empty, what its bytes
  /// tell. Throws Error{io}.
  explicit SceneSource(std::string argument, std::string input_format = {});

  /// For messages: the file as given, "<stdin>", or "<stdin>.glb" and the like, which tells the format as a file's
  /// does.
  std::string const& name() const { return name_; }
  /// The file's name without folder and extension, or "stdin": what a picture is called when nothing else says.
  std::string stem() const;

  /// The job for this scene: `common` with its name. The bytes of standard input stay here.
  Job job(Job common) const {
    common.scene = name_;
    return common;
  }

  /// With the environment that `reading` chooses. Same exceptions as EsdfScript::from_file, import_model and
  /// environment_map, and Error{usage} for times of what has none.
  LoadedScene load(SceneReading const& reading, LoadOptions const& options = {}) const;

 private:
  LoadedScene read(SceneReading const& reading, LoadOptions const& options) const;

  std::string name_;
  std::optional<std::string> bytes_;  // of standard input
};

}  // namespace lichtraum::app
