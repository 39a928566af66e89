#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lichtraum/camera.hpp"

struct GLFWwindow;

namespace lichtraum::view {

/// A picture on the graphics card.
struct ShownPicture {
  unsigned texture = 0;
  Resolution size;

  /// `pixels`: red, green, blue and alpha, a byte each, first row at the top.
  void upload(Resolution const& new_size, std::vector<unsigned char> const& pixels);
};

/// With what was held down when it was pressed, which may be let go of before a slow frame looks.
struct PressedKey {
  int key = 0;  ///< GLFW_KEY_*
  bool with_shift = false;
};

/// GLFW's and Dear ImGui's part of a window.
struct Graphics {
  GLFWwindow* window = nullptr;
  ShownPicture picture;
  ShownPicture marking;
  /// Since they were handled last. Characters rather than keys, so that a keyboard's layout plays no role. A key that
  /// is held down comes again only where it moves something: arrows, + and -.
  std::vector<char32_t> characters;
  std::vector<PressedKey> keys;
  bool is_key_held = false;          ///< the last that came
  std::vector<std::string> dropped;  ///< files
  bool is_close_asked = false;       ///< by its button, or however else the desktop lets users close windows

  /// Throws Error{unavailable} when there is no display, as `open` does.
  Graphics();
  ~Graphics();
  Graphics(Graphics const&) = delete;
  Graphics& operator=(Graphics const&) = delete;

  /// `ui_scale`: the size of text and widgets; nothing: as the display asks for.
  void open(std::string const& title, Resolution const& size, std::optional<double> ui_scale);
  Resolution framebuffer_size() const;
  /// What of a window's size the screen has room for.
  static Resolution fitting(Resolution const& size);
  void resize(Resolution const& size) const;
  void begin_drawing();
  /// Puts what was drawn since on the screen.
  void show_drawing() const;
  /// Of text and widgets: 1 where Dear ImGui's units are those of a display with 96 dots an inch.
  float ui_scale() const { return ui_scale_; }

 private:
  void fit_to_display();

  std::optional<double> given_ui_scale_;
  float ui_scale_ = 0;
  float pixels_per_unit_ = 0;
};

/// A length of Dear ImGui's at scale 1, at the scale of the current frame.
float scaled(float length);

}  // namespace lichtraum::view
