#include "app/loaded_scene.hpp"

namespace lichtraum::app {

std::vector<Diagnostic> const& LoadedScene::diagnostics() const {
  auto const* script = std::get_if<EsdfScript>(&content_);
  return script ? script->diagnostics() : std::get<GltfModel>(content_).diagnostics;
}

Scene const& LoadedScene::scene() const {
  auto const* script = std::get_if<EsdfScript>(&content_);
  return script ? script->scene() : std::get<GltfModel>(content_).scene;
}

void LoadedScene::play(std::function<void(Scene const&, std::size_t)> const& draw) const {
  auto const* script = std::get_if<EsdfScript>(&content_);
  if (!script || script->scene().renders.empty()) return draw(scene(), 0);
  std::size_t index = 0;
  script->play([&](Scene const& scene, RenderCommand const&) {
    draw(scene, index++);
    return true;
  });
}

}  // namespace lichtraum::app
