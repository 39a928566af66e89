#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <fstream>
#include <iterator>

#include "lichtraum/image_io.hpp"
#include "view/edited_scene.hpp"
#include "view/unused_name.hpp"
#include "view/window/window.hpp"

// What a Window writes: pictures, edited scenes, and what is copied.

namespace lichtraum::view {

void Window::save() {
  if (!frame_) return;
  saves_when_whole_ = !is_picture_whole();
  if (saves_when_whole_) {
    playback_.pause();
    return tell("the picture is saved once all its pixels are there", until_dismissed);
  }
  std::string const stem = std::filesystem::path(scene_.file).stem().string();
  save_as(stem + "_view", ".png", [this] { return image_format_named("png").encode(frame_->image, {}); });
}

bool Window::is_picture_whole() const { return frame_->pass.pixel_side == 1 && frame_->view_number == view_number_; }

void Window::save_edits() {
  // Beside the scene, from where it names its files.
  std::filesystem::path const file = scene_.file;
  bool const is_saved = save_as((file.parent_path() / file.stem()).string() + "_edited", ".sdf", [&] {
    constexpr std::uintmax_t most_bytes = 256u << 20;
    std::error_code unknown;
    if (std::filesystem::file_size(file, unknown) > most_bytes || unknown) {
      throw Error(ErrorKind::cannot_create, "nothing is saved: the scene's file is too large or gone");
    }
    std::ifstream in(file, std::ios::binary);
    std::string const text{std::istreambuf_iterator<char>(in), {}};
    std::string edited = edited_scene(text, panel_.values());
    SceneReading const& reading = options_.render.job.reading;
    EsdfOptions how;
    static_cast<EsdfDialect&>(how) = reading.dialect;
    how.allowed_paths = reading.allowed_paths;
    how.models = scene_.models;
    check_readable(edited, file, how);
    return edited;
  });
  if (is_saved) has_unsaved_edits_ = false;
}

bool Window::save_as(std::string const& stem, char const* extension, std::function<std::string()> const& contents) {
  try {
    std::string const name = unused_name(stem, extension);
    write_file_atomically(name, contents());
    problem_.clear();
    tell("saved " + name, seconds_to_read);
    console_.info("saved " + name);
    return true;
  } catch (std::exception const& error) {
    problem_ = error.what();
    console_.error(error.what());
    return false;
  }
}

void Window::copy_camera() { copy(camera_as_esdf(camera_seen_through(), shown_size_)); }

void Window::copy(std::string const& text) {
  tell("copied to the clipboard", seconds_to_read);
  glfwSetClipboardString(graphics_->window, text.c_str());
  try {
    app::write_standard_output(text);
  } catch (Error const&) {  // nobody reads it there; the clipboard has it
  }
}

}  // namespace lichtraum::view
