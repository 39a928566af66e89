#include "app/loaded_scene.hpp"

namespace lichtraum::app {

void LoadOptions::set_drawing(Job const& job, DeviceKind drawing_device) {
  check_view(job.view);  // models are lit from where its `up` says before their pictures are planned
  device = drawing_device;
  integrator = asked_integrator(job);
  up = job.view.up;
  has_size = job.size.has_value();
}

LoadedScene::LoadedScene(GltfAnimation animation, std::optional<double> time_seconds, std::vector<double> times_seconds,
                         std::function<void(Scene&)> adjust)
    : content_([&] {
        AnimatedModel model{std::move(animation), std::move(times_seconds), std::move(adjust), {}};
        model.first = model.pose(model.times_seconds.empty() ? time_seconds : model.times_seconds.front());
        return model;
      }()) {}

bool LoadedScene::can_be_posed() const {
  auto const* animated = std::get_if<AnimatedModel>(&content_);
  return animated && animated->first.contents.animation;
}

Scene LoadedScene::pose(double time_seconds) {
  return std::move(std::get<AnimatedModel>(content_).pose(time_seconds).scene);
}

Model LoadedScene::AnimatedModel::pose(std::optional<double> time_seconds) {
  Model model = animation.pose(time_seconds);
  if (adjust) adjust(model.scene);
  return model;
}

Model const& LoadedScene::model() const {
  auto const* animated = std::get_if<AnimatedModel>(&content_);
  return animated ? animated->first : std::get<Model>(content_);
}

std::vector<Diagnostic> const& LoadedScene::diagnostics() const {
  auto const* script = std::get_if<EsdfScript>(&content_);
  return script ? script->diagnostics() : model().diagnostics;
}

Scene const& LoadedScene::scene() const {
  auto const* script = std::get_if<EsdfScript>(&content_);
  return script ? script->scene() : model().scene;
}

void LoadedScene::rewind() {
  if (auto* const script = std::get_if<EsdfScript>(&content_)) script->rewind();
}

std::vector<double> const& LoadedScene::times_seconds() const {
  static std::vector<double> const none;
  auto const* animated = std::get_if<AnimatedModel>(&content_);
  return animated ? animated->times_seconds : none;
}

void LoadedScene::play(std::function<bool(Scene const&, std::size_t)> const& draw) {
  if (auto* const animated = std::get_if<AnimatedModel>(&content_); animated && !animated->times_seconds.empty()) {
    for (std::size_t i = 0; i < animated->times_seconds.size(); ++i) {
      bool const goes_on =
          i == 0 ? draw(animated->first.scene, i) : draw(animated->pose(animated->times_seconds[i]).scene, i);
      if (!goes_on) return;
    }
    return;
  }
  auto const* script = std::get_if<EsdfScript>(&content_);
  if (!script || script->scene().renders.empty()) {
    draw(scene(), 0);
    return;
  }
  std::size_t index = 0;
  script->play([&](Scene const& scene, RenderCommand const&) { return draw(scene, index++); });
}

}  // namespace lichtraum::app
