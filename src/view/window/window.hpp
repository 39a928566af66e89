#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/view_options.hpp"
#include "view/folder_files.hpp"
#include "view/orbit_camera.hpp"
#include "view/playback.hpp"
#include "view/window/graphics.hpp"
#include "view/window/panel.hpp"
#include "view/worker.hpp"

namespace lichtraum::view {

/// A window on a scene. Mouse and keys move the camera, a Worker traces what it sees.
class Window {
 public:
  /// Opens it. Throws Error{unavailable} when there is no display.
  Window(app::SceneSource const& source, app::ViewOptions const& options, app::Console const& console);
  ~Window();
  Window(Window const&) = delete;
  Window& operator=(Window const&) = delete;

  /// Until it is closed. Throws what Worker::news throws.
  void run();

 private:
  /// Whether there was something to be seen.
  bool take_news();
  /// At the next click or key: they were read.
  void dismiss_messages();
  void handle_mouse();
  void handle_keys();
  void handle_character(char32_t character);
  /// Whether edits would be lost that were not saved: then says so, and that `way` loses them all the same when it is
  /// gone again.
  bool warns_of_edits(std::string const& way);
  void close();
  /// Of what lies over the picture, a menu or the list of keys. Whether there was any.
  bool close_topmost();
  void draw();
  void draw_panel();
  void draw_awaited() const;
  void draw_message(std::string const& text, Rgb const& color) const;
  std::string statistics() const;

  /// What was read last: after a step to a file that could not be, the one behind it is next.
  void skip(std::string const& problem);
  void open(std::filesystem::path const& file);
  void open_dropped();
  void step(int direction);
  /// What the clock, the keys and the time line do to an animation.
  void begin_animation(SceneView const& before);
  void advance_animation();
  void handle_animation_key(int key);
  /// Its height; 0 without an animation.
  float draw_time_line();
  void choose_animation(std::size_t number);
  void take_pose(PosedView posed);
  void choose_camera(std::size_t number);
  /// As it is now: where it was moved, with the lens that the panel gives it.
  Camera camera_seen_through() const;
  /// From where a camera stands, with the lens that the panel gives it; look_through takes the camera's.
  void look_from(Camera const& camera, Resolution const& made_for);
  void look_through(Camera const& camera, Resolution const& made_for);
  /// Than this one of the scene's, by the panel or a click.
  bool has_other_lens(Camera const& camera) const;
  Vec3 center_of_interest() const;
  /// Of the ball around it; 0: unknown.
  double radius_of_interest() const;
  void frame_everything();
  void show();
  void show(FilmPlane plane);
  void mark_selection();
  /// The picture, now or once the current view has one with all pixels.
  void save();
  bool is_picture_whole() const;
  /// The scene with what was changed of lights, materials and environment, as a new file beside it.
  void save_edits();
  /// Is shown for so many seconds: long enough to be read, or until a key or the mouse takes it away.
  void tell(std::string text, double seconds);
  static constexpr double seconds_to_read = 5;
  static constexpr double until_dismissed = std::numeric_limits<double>::infinity();
  /// To a new file with a number. Says where, or why not. Whether it was saved.
  bool save_as(std::string const& stem, char const* extension, std::function<std::string()> const& contents);
  void copy_camera();
  /// To the clipboard, and to standard output for those whose clipboard ends with the window.
  void copy(std::string const& text);
  /// 0 while it is hidden. In Dear ImGui's units.
  float panel_width() const;
  /// Beside the panel.
  Resolution picture_size() const;

  app::ViewOptions const& options_;
  app::Console const& console_;
  FolderFiles files_;
  std::unique_ptr<Graphics> graphics_;
  SceneView scene_;
  Vec3 focus_{0};  // what a lens shows sharp, wherever the camera moves
  std::optional<OrbitCamera> camera_;
  bool is_moved_ = false;  // by hand: then it stays where it is when the scene is read again
  Resolution shown_size_;
  std::optional<Frame> frame_;
  unsigned view_number_ = 0;  // of the current view
  bool saves_when_whole_ = false;
  std::string problem_;
  std::string notice_;  // what went well
  double notice_end_ = 0;
  std::string skipped_;  // the problem of the last file that was skipped
  std::string device_;
  std::string awaited_;  // the file that is being read; empty: none
  double awaited_since_ = 0;
  bool has_unsaved_edits_ = false;
  std::string warned_way_;  // to lose them
  bool is_help_open_ = false;
  bool is_panel_open_ = true;
  Overlays overlays_;
  Panel panel_;
  Playback playback_;
  float time_line_height_ = 0;        // in the current drawing; 0: there is none
  std::optional<double> posed_time_;  // asked for last; nothing: the model stands as its nodes do
  bool is_pose_awaited_ = false;      // the next is asked for when this one is there
  bool has_marking_ = false;          // of the current view
  double dragged_ = 0;                // pixels, since the left button was pressed on the picture; negative: elsewhere
  std::unique_ptr<Worker> worker_;    // last: it is ended first
};

}  // namespace lichtraum::view
