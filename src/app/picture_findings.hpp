#pragma once

#include <memory>
#include <vector>

#include "app/scene_loader.hpp"

namespace lichtraum::app {

/// What pictures fail to show, and why. Each finding once a scene.
class PictureFindings {
 public:
  /// Both must outlive it.
  PictureFindings(Renderer& renderer, RenderOptions const& options) : renderer_(renderer), options_(options) {}

  /// What follows is of that scene.
  void begin(SceneOpened const& scene);

  /// Of what the renderer was given to draw the picture of.
  std::vector<Diagnostic> of_scene(PictureReady const& ready);
  /// Of a picture, all of which was traced. May give the renderer another scene.
  std::vector<Diagnostic> of_picture(PictureReady const& ready, PicturePlan const& plan, RayCounts const& rays);

  /// What both will find, mostly without tracing all of the picture. Gives the renderer the scene; throws what that
  /// throws.
  std::vector<Diagnostic> predicted(PictureReady const& ready, PicturePlan const& plan);

 private:
  Diagnostic warning(std::string message, std::string hint = {}) const;
  Diagnostic explain_empty_view(PictureReady const& ready, PicturePlan const& plan);
  bool shows_something(EsdfDialect const& dialect, RenderRequest request, std::size_t wanted);

  Renderer& renderer_;
  RenderOptions const& options_;
  std::shared_ptr<SceneSource const> source_;
  bool is_model_ = false;
  bool has_explained_view_ = false;
};

}  // namespace lichtraum::app
