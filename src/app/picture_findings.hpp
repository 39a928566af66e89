#pragma once

#include <memory>
#include <vector>

#include "app/scene_loader.hpp"
#include "app/whiteness.hpp"

namespace lichtraum::app {

/// What tells whether a picture shows anything.
class Sight {
 public:
  /// Of a part of it, or all, as it was traced.
  void add(RayCounts const& rays, Film& film);
  /// Of the same, what people see of its radiance.
  void add(Image const& pixels, Development const& development) { whiteness_.add(pixels, development); }

  /// No ray of the camera met anything.
  bool is_empty() const { return camera_rays_ > 0 && camera_hits_ == 0; }
  /// All of it, though the camera sees something.
  bool is_black() const { return camera_hits_ > 0 && is_black_; }
  /// Rays meet surfaces, and show none of them. Known where normals were traced.
  bool shows_no_surface() const { return camera_hits_ > 0 && !has_normals_; }
  /// 0..1, see Whiteness; 0 where only films were added.
  double white_share(PictureReady const& ready) const;

 private:
  std::uint64_t camera_rays_ = 0;
  std::uint64_t camera_hits_ = 0;
  bool is_black_ = true;
  bool has_normals_ = false;  // or nobody knows
  Whiteness whiteness_;
};

/// What pictures fail to show, and why. Each finding once a scene.
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

  Diagnostic explain_missing_light(SceneLight light, PicturePlan const& plan) const;
  Diagnostic explain_black_picture(PictureReady const& ready, PicturePlan const& plan) const;
  Diagnostic explain_white_picture(PictureReady const& ready, PicturePlan const& plan, double share) const;
  Diagnostic explain_empty_view(PictureReady const& ready, PicturePlan const& plan);
  DefinedBelow defined_below(PicturePlan const& plan) const;
  bool shows_something(EsdfDialect const& dialect, RenderRequest request, std::size_t wanted);

  Renderer& renderer_;
  RenderOptions const& options_;
  std::shared_ptr<SceneSource const> source_;
  bool is_model_ = false;
  bool has_explained_view_ = false;
  bool has_told_of_light_ = false;
  bool has_told_of_white_ = false;
};

}  // namespace lichtraum::app
