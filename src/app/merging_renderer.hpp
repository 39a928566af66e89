#pragma once

#include <memory>
#include <string>
#include <vector>

#include "farm/unit_file.hpp"
#include "lichtraum/renderer.hpp"

namespace lichtraum::app {

/// Takes pictures out of a plan's units instead of tracing them: the first one that is rendered is the plan's first,
/// and so on; each at once, or in bands as wide as it is, from its top. All else is done by another renderer.
class MergingRenderer final : public Renderer {
 public:
  /// `allowed_class`: what must have drawn the units; empty: any may have.
  MergingRenderer(farm::PlanFolder const& folder, std::string allowed_class, std::unique_ptr<Renderer> other);

  /// All units of the plan; to be called before anything is rendered. Throws Error{try_again} that names those that are
  /// missing, or that cannot be used and were set aside. `progress` cannot stop it.
  void check_units(ProgressFunction const& progress);

  DeviceInfo const& device() const override { return device_; }
  std::shared_ptr<PreparedScene const> prepare(Scene const& scene, std::string_view root,
                                               std::shared_ptr<PreparedScene const> const& previous) const override {
    return other_->prepare(scene, root, previous);
  }
  std::shared_ptr<PreparedScene const> edit(std::shared_ptr<PreparedScene const> const& prepared,
                                            SceneEdits const& edits) const override {
    return other_->edit(prepared, edits);
  }
  SceneStatistics set_scene(std::shared_ptr<PreparedScene const> scene) override {
    return other_->set_scene(std::move(scene));
  }
  RenderResult render(RenderRequest const& request, Film& film, ProgressFunction const& progress) override;
  Image develop(Film film, Development const& development) override {
    return other_->develop(std::move(film), development);
  }
  std::vector<float> filter_noise(NoisyPicture const& picture) override { return other_->filter_noise(picture); }

 private:
  farm::PlanFolder const& folder_;
  std::string allowed_class_;
  std::unique_ptr<Renderer> other_;
  DeviceInfo device_;
  std::vector<RayCounts> rays_;  // that each picture's units took
  int picture_ = -1;
};

}  // namespace lichtraum::app
