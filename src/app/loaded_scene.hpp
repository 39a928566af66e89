#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "app/environment_maps.hpp"
#include "app/files_read.hpp"
#include "lichtraum/esdf.hpp"
#include "lichtraum/gltf.hpp"
#include "lichtraum/job.hpp"

namespace lichtraum::app {

/// What goes beyond one picture when scenes and models are read.
struct LoadOptions {
  FileObserver on_read;                           ///< may be empty
  std::shared_ptr<ModelCache> models;             ///< null: each scene has one for itself
  DeviceKind device = DeviceKind::cpu;            ///< that draws: see usual_integrator
  std::optional<Integrator> integrator;           ///< that was asked for: by paths, models stand in the studio
  std::optional<Vec3> up;                         ///< of models, where not +y (JobView::up)
  std::shared_ptr<EnvironmentMaps> environments;  ///< null: each scene has its maps for itself
  /// A picture of a model's animation at each; empty: one, see ModelChoice::time_seconds.
  std::vector<double> times_seconds;
  std::optional<double> whole_animation_rate;  ///< a model's whole animation, at that many pictures a second
  bool is_posed_later = false;                 ///< see LoadedScene::pose
  bool has_size = false;                       ///< see EsdfOptions

  /// What of it depends on who draws, and how that was asked for. Throws Error{usage} for a view that no camera has.
  void set_drawing(Job const& job, DeviceKind drawing_device);
};

/// What a scene file or a model file became.
class LoadedScene {
 public:
  explicit LoadedScene(EsdfScript script) : content_(std::move(script)) {}
  explicit LoadedScene(Model model) : content_(std::move(model)) {}
  /// A model at several times, or, without any, as it is at `time_seconds`. `adjust` changes the scene of each; may be
  /// empty.
  LoadedScene(GltfAnimation animation, std::optional<double> time_seconds, std::vector<double> times_seconds,
              std::function<void(Scene&)> adjust);

  /// Of all that it was read from, its environment included.
  FilesRead const& files() const { return *files_; }
  void set_files(std::shared_ptr<FilesRead const> files) { files_ = std::move(files); }

  /// What a model file holds beside its scene; null for a scene file.
  ModelContents const* contents() const { return is_model() ? &model().contents : nullptr; }
  bool is_model() const { return !std::holds_alternative<EsdfScript>(content_); }
  std::vector<Diagnostic> const& diagnostics() const;
  /// At the end of the file, unless it was rewound; of a model at several times at the first of them.
  Scene const& scene() const;
  /// See EsdfScript::rewind. Nothing changes in a model.
  void rewind();
  /// Empty unless it is a model at several times.
  std::vector<double> const& times_seconds() const;

  /// Calls `draw` for each picture that the file asks for, or each time, with the scene as it is there and its number;
  /// once at the end for a file that asks for none. `draw` returns false to stop.
  void play(std::function<bool(Scene const&, std::size_t)> const& draw);

  /// Whether there is an animation that `pose` goes through.
  bool can_be_posed() const;
  /// The model at another time: with the same materials, and with geometry that is not deformed. Exceptions as
  /// GltfAnimation::pose. Only where can_be_posed().
  Scene pose(double time_seconds);

 private:
  struct AnimatedModel {
    GltfAnimation animation;
    std::vector<double> times_seconds;
    std::function<void(Scene&)> adjust;
    Model first;

    Model pose(std::optional<double> time_seconds);
  };
  Model const& model() const;

  std::variant<EsdfScript, Model, AnimatedModel> content_;
  std::shared_ptr<FilesRead const> files_ = std::make_shared<FilesRead>();
};

}  // namespace lichtraum::app
