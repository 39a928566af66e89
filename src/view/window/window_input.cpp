#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "view/window/window.hpp"

// What mouse and keys do to a Window.

namespace lichtraum::view {

void Window::dismiss_messages() {
  bool const is_click = ImGui::IsMouseClicked(ImGuiMouseButton_Left) || ImGui::IsMouseClicked(ImGuiMouseButton_Right) ||
                        ImGui::IsMouseClicked(ImGuiMouseButton_Middle);
  if (!is_click && graphics_->keys.empty() && graphics_->characters.empty()) return;
  if (frame_) problem_.clear();  // without a picture it is all that there is to see
  notice_.clear();
}

void Window::handle_mouse() {
  ImGuiIO const& io = ImGui::GetIO();
  if (!camera_ || io.WantCaptureMouse) {
    dragged_ = -1;
    return;
  }
  float const left = panel_width(), width = std::max(1.0f, io.DisplaySize.x - left);
  constexpr double most_of_a_click = 3;  // a hand is not quite still
  bool const is_left = ImGui::IsMouseDown(ImGuiMouseButton_Left);
  if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) dragged_ = 0;
  if (is_left && dragged_ >= 0) dragged_ += double(std::abs(io.MouseDelta.x) + std::abs(io.MouseDelta.y));
  if (ImGui::IsMouseReleased(ImGuiMouseButton_Left) && dragged_ >= 0 && dragged_ <= most_of_a_click && !io.KeyShift &&
      ImGui::IsMousePosValid()) {
    worker_->look_at(int((io.MousePos.x - left) / width * float(shown_size_.width)),
                     int(io.MousePos.y / io.DisplaySize.y * float(shown_size_.height)));
  }
  bool const is_panning = ImGui::IsMouseDown(ImGuiMouseButton_Right) || ImGui::IsMouseDown(ImGuiMouseButton_Middle) ||
                          (is_left && io.KeyShift);
  double const right = io.MouseDelta.x / width;
  double const down = io.MouseDelta.y / width;
  bool moves = false;
  if (is_panning && (right != 0 || down != 0)) {
    camera_->pan(-right, down);
    moves = true;
  } else if (is_left && dragged_ > most_of_a_click && (right != 0 || down != 0)) {
    camera_->orbit(-360 * right, 360 * down);
    moves = true;
  }
  if (io.MouseWheel != 0) {
    camera_->zoom(std::pow(0.85, double(io.MouseWheel)));
    moves = true;
  }
  if (!moves) return;
  is_moved_ = true;
  show();
}

void Window::handle_keys() {
  if (ImGui::GetIO().WantTextInput) {  // a number is being typed
    graphics_->characters.clear();
    graphics_->keys.clear();
    return;
  }
  for (char32_t const character : std::exchange(graphics_->characters, {})) handle_character(character);
  constexpr double step_degrees = 5;
  for (auto const [key, with_shift] : std::exchange(graphics_->keys, {})) {
    if (key == GLFW_KEY_ESCAPE && !close_topmost()) close();
    if (key == GLFW_KEY_PAGE_DOWN) step(1);
    if (key == GLFW_KEY_PAGE_UP) step(-1);
    if (key == GLFW_KEY_TAB) is_panel_open_ = !is_panel_open_;
    bool const is_sideways = key == GLFW_KEY_LEFT || key == GLFW_KEY_RIGHT;
    if (playback_.duration() > 0 && !with_shift) {
      handle_animation_key(key);
      if (is_sideways) continue;
    }
    double const right = key == GLFW_KEY_RIGHT ? step_degrees : key == GLFW_KEY_LEFT ? -step_degrees : 0;
    double const up = key == GLFW_KEY_UP ? step_degrees : key == GLFW_KEY_DOWN ? -step_degrees : 0;
    if (!camera_ || (right == 0 && up == 0)) continue;
    camera_->orbit(right, up);
    is_moved_ = true;
    show();
  }
}

void Window::handle_character(char32_t character) {
  if (character == '?') is_help_open_ = !is_help_open_;
  if (character == 'q') close();
  if (!camera_) return;
  if (character >= '1' && character <= '9') choose_camera(character - '1');
  if (character == 'p') show(FilmPlane::radiance);
  if (character == 'd') show(FilmPlane::depth);
  if (character == 'n') show(FilmPlane::normal);
  if (character == 'o') show(FilmPlane::object);
  if (character == 's') save();
  if (character == 'w') save_edits();
  if (character == 'c') copy_camera();
  if (character == 'f') frame_everything();
  bool const is_overlay = character == 'g' || character == 'x' || character == 'e';
  if (is_overlay) {
    bool& shown = character == 'g' ? overlays_.grid : character == 'x' ? overlays_.axes : overlays_.edges;
    shown = !shown;
    view_number_ = worker_->overlay(overlays_);
  }
  if (character == 'r') {
    look_through(scene_.request.camera, scene_.request.resolution);
    is_moved_ = false;
    show();
  }
  if (character == '+' || character == '-') {
    camera_->zoom(character == '+' ? 0.9 : 1 / 0.9);
    is_moved_ = true;
    show();
  }
}

}  // namespace lichtraum::view
