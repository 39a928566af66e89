#pragma once

#include <functional>
#include <optional>
#include <string>

#include "view/window/typed_edit.hpp"
#include "view/worker.hpp"

namespace lichtraum::view {

/// How wide the panel is in a window of that width, and beside a picture of that width.
float panel_width_in(float window_width, float ui_scale);
float panel_width_beside(float picture_width, float ui_scale);

/// What is shown beside the picture: numbers, the objects as a tree, what is selected, and what can be changed: how the
/// picture is developed, environment, lights and materials.
class Panel {
 public:
  /// Another scene, or the same read again: nothing is selected or changed.
  void set_scene(SceneView const& scene);
  /// Selects what was found under a pixel. Whether that changes the selection.
  bool select(std::optional<SeenPoint> const& seen);

  /// What a user has changed while it was drawn.
  struct Changes {
    bool plane = false;
    bool values = false;
    bool selection = false;
    bool development = false;
    bool aperture = false;
    std::string copied;  ///< as eSDF, for the clipboard; empty: nothing
  };
  /// In the current frame of Dear ImGui, at the window's left edge. `draw_menus`: called where its menu bar is.
  Changes draw(float width, std::function<void()> const& draw_menus);

  FilmPlane plane = FilmPlane::radiance;
  Development development;
  double aperture = 0;  ///< of the camera's lens, in units of the world
  SceneValues const& values() const { return values_; }
  ObjectTree::Objects selected_objects() const { return tree_.selected_objects(); }

 private:
  bool draw_views();
  bool draw_objects();
  void draw_selection() const;
  void draw_picture(Changes& changes);
  bool draw_environment();
  void draw_lights(Changes& changes);
  void draw_materials(Changes& changes);

  std::shared_ptr<app::LoadedScene const> loaded_;  // keeps the tree's shapes
  ObjectTree tree_;
  SceneValues values_;
  TypedEdit<Light> typed_light_;
  TypedEdit<Material> typed_material_;
  Development original_development_;
  double original_aperture_ = 0;
  double scene_size_ = 1;
  std::optional<SeenPoint> seen_;  // of the selected object, when it was selected in the picture
  bool scrolls_ = false;
};

}  // namespace lichtraum::view
