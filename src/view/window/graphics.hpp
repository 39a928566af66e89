#pragma once

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

/// GLFW's and Dear ImGui's part of a window.
struct Graphics {
  GLFWwindow* window = nullptr;
  ShownPicture picture;
  ShownPicture marking;
  /// Since they were handled last. Characters rather than keys, so that a keyboard's layout plays no role.
  std::vector<char32_t> characters;
  std::vector<int> keys;
  std::vector<std::string> dropped;  ///< files

  /// Throws Error{unavailable} when there is no display, as `open` does.
  Graphics();
  ~Graphics();
  Graphics(Graphics const&) = delete;
  Graphics& operator=(Graphics const&) = delete;

  void open(std::string const& title, Resolution const& size);
  Resolution framebuffer_size() const;
  /// To this size, or what of it the screen has room for.
  void resize(Resolution const& size) const;
  void begin_drawing() const;
  /// Puts what was drawn since on the screen.
  void show_drawing() const;
};

}  // namespace lichtraum::view
