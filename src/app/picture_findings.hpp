#pragma once

#include <memory>
#include <vector>

#include "app/scene_loader.hpp"

namespace lichtraum::app {

/// What tells whether a picture shows anything.
struct Sight {
  bool is_empty = false;  ///< no ray of the camera met anything
  bool is_black = false;  ///< all of it, though the camera sees something

  Sight() = default;
  /// Of a film as it was traced.
  Sight(RayCounts const& rays, Film& film);
};

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
  std::vector<Diagnostic> of_picture(PictureReady const& ready, PicturePlan const& plan, Sight const& sight);

  /// What both will find, mostly without tracing all of the picture. Gives the renderer the scene; throws what that
  /// throws.
  std::vector<Diagnostic> predicted(PictureReady const& ready, PicturePlan const& plan);

 private:
  Diagnostic warning(DiagnosticCode code, std::string message, std::string hint = {}) const;
  Diagnostic explain_missing_light(SceneLight light) const;
  Diagnostic explain_empty_view(PictureReady const& ready, PicturePlan const& plan);
  bool shows_something(EsdfDialect const& dialect, RenderRequest request, std::size_t wanted);

  Renderer& renderer_;
  RenderOptions const& options_;
  std::shared_ptr<SceneSource const> source_;
  bool is_model_ = false;
  bool has_explained_view_ = false;
  bool has_told_of_light_ = false;
};

}  // namespace lichtraum::app
