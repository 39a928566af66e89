#pragma once

#include <exception>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <variant>
#include <vector>

#include "app/channel.hpp"
#include "app/picture_plan.hpp"
#include "app/scene_light.hpp"

namespace lichtraum::app {

/// A scene was read and all its pictures were planned.
struct SceneOpened {
  std::shared_ptr<SceneSource const> source;
  bool is_model = false;
  bool has_environment = false;
  std::optional<ModelContents::Animation> animation;  ///< that the model is posed by
  double load_ms = 0;
  std::vector<Diagnostic> diagnostics;
  std::vector<PicturePlan> plans;
};

/// A picture of the scene that was opened last can be traced.
struct PictureReady {
  std::size_t number = 0;  ///< in SceneOpened::plans
  RenderRequest request;
  Development development;
  Background background;  ///< that of the request, or the scene's
  std::shared_ptr<PreparedScene const> scene;
  std::string fingerprint;  ///< for the picture's file
  SceneLight light = SceneLight::some;
  std::string map_repairs;  ///< EnvironmentMap::repairs
  std::string denoiser;     ///< what is to take the noise out of it; empty: nothing
  bool is_done = false;     ///< with --resume: the file is there, and is this picture
  double load_ms = 0;       ///< bringing the scene to where it is in this picture
};

/// Nothing more comes of the scene, as it is at its end or as `failure` says.
struct SceneClosed {
  std::exception_ptr failure;
};

using LoaderMessage = std::variant<SceneOpened, PictureReady, SceneClosed>;

/// Reads scenes and prepares their pictures, in order, in a thread of its own: always the next one while the caller
/// traces. For each input there is one SceneOpened (unless it fails before), its PictureReady and one SceneClosed.
class SceneLoader {
 public:
  /// All arguments must outlive it. It is the only one to use `names`.
  SceneLoader(std::vector<std::string> const& inputs, RenderOptions const& options, OutputNames& names,
              Renderer const& renderer, Denoiser& denoiser);
  /// Stops after the current item.
  ~SceneLoader();
  SceneLoader(SceneLoader const&) = delete;
  SceneLoader& operator=(SceneLoader const&) = delete;

  /// What comes next; nothing when that takes longer than 50 ms. Not to be called after the last SceneClosed.
  std::optional<LoaderMessage> next();

 private:
  void load(std::string const& input);
  LoadedScene read(SceneSource const& source);

  RenderOptions const& options_;
  OutputNames& names_;
  Renderer const& renderer_;
  Denoiser& denoiser_;
  std::shared_ptr<PreparedScene const> previous_;
  Channel<LoaderMessage> channel_;
  std::jthread thread_;
};

}  // namespace lichtraum::app
