#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "control.hpp"
#include "options.hpp"
#include "picture.hpp"

namespace lichtraum::python {

/// A scene that was read: as it is at the end of its file, without the environment that a picture may choose.
struct ReadScene {
  std::string name;  ///< of its file
  bool is_model = false;
  Scene scene;
  std::vector<Diagnostic> diagnostics;
  SourceFiles files;
  /// Of `scene`: it may still be drawn when whoever asked for that was interrupted, and edits it.
  std::unique_ptr<std::mutex> mutex = std::make_unique<std::mutex>();
};

/// The reading of `options`. Exceptions as app::SceneSource::load.
ReadScene read_scene(std::string const& path, app::RenderOptions const& options);

/// A renderer, and what it keeps from one picture to the next. Several threads may ask; they take turns.
class Session {
 public:
  /// `device`, `traversal`: as --device and --traversal have them. Throws Error{no_device}, Error{usage}.
  Session(std::string const& device, std::string const& traversal);

  DeviceInfo const& device() const { return renderer_->device(); }
  /// Why there is no better device; empty where nothing is wrong.
  std::vector<std::string> const& warnings() const { return warnings_; }

  /// The file's picture number `number`, from 0, as `lichtraum render` draws it.
  Picture draw_file(std::string const& path, app::RenderOptions const& options, int number, Control& control);
  /// `scene` is as before when this returns.
  Picture draw_scene(ReadScene& scene, app::RenderOptions const& options, int number, Control& control);

 private:
  /// Reading adds to `files`.
  app::LoadOptions load_options(app::RenderOptions const& options, SourceFiles& files);

  std::mutex mutex_;
  std::vector<std::string> warnings_;
  std::unique_ptr<Renderer> renderer_;
  std::shared_ptr<PreparedScene const> previous_;
  std::shared_ptr<ModelCache> models_ = make_model_cache();
  std::shared_ptr<app::EnvironmentMaps> environments_ = std::make_shared<app::EnvironmentMaps>();
};

}  // namespace lichtraum::python
