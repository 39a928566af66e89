#pragma once

#include <memory>
#include <set>
#include <string>
#include <vector>

#include "app/picture_faults.hpp"
#include "app/scene_loader.hpp"

namespace lichtraum::app {

/// What pictures fail to show, and why, as far as their files tell. Each finding once a scene.
class PictureFindings {
 public:
  /// Both must outlive it.
  PictureFindings(Renderer& renderer, RenderOptions const& options) : renderer_(renderer), options_(options) {}

  /// What follows is of that scene.
  void begin(SceneOpened const& scene);

  /// Of what the renderer was given to draw the picture of.
  std::vector<Diagnostic> of_scene(PictureReady const& ready, PicturePlan const& plan);
  /// Of a picture, all of which was traced. May give the renderer another scene.
  std::vector<Diagnostic> of_picture(PictureReady const& ready, PicturePlan const& plan, Sight const& sight);

  /// What both will find, mostly without tracing all of the picture. Gives the renderer the scene; throws what that
  /// throws.
  std::vector<Diagnostic> predicted(PictureReady const& ready, PicturePlan const& plan);

 private:
  /// What the scene defines only below the `render` of a picture, so that this does not show it: names, or nothing.
  struct DefinedBelow {
    std::string shape;
    std::string light;
  };

  std::string better_hint(PictureFault fault, PicturePlan const& plan);
  DefinedBelow defined_below(PicturePlan const& plan) const;
  bool shows_something(EsdfDialect const& dialect, PicturePlan plan);

  Renderer& renderer_;
  RenderOptions const& options_;
  std::shared_ptr<SceneSource const> source_;
  bool is_model_ = false;
  std::set<PictureFault> told_;
};

}  // namespace lichtraum::app
