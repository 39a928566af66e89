#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "view/window/keys.hpp"
#include "view/window/window.hpp"

// How a Window plays the animation of a model.

namespace lichtraum::view {
namespace {

std::string label_of(ModelContents::Animation const& animation, std::size_t number) {
  return animation.name.empty() ? fmt::format("animation {}", number) : animation.name;
}

/// The one that it can be posed by.
std::optional<std::size_t> animation_of(SceneView const& scene) {
  if (!scene.loaded || !scene.loaded->can_be_posed()) return std::nullopt;
  ModelContents const* const contents = scene.loaded->contents();
  return contents ? contents->animation : std::nullopt;
}

}  // namespace

void Window::begin_animation(SceneView const& before) {
  Playback const last = std::exchange(playback_, {});
  is_pose_awaited_ = false;
  posed_time_ = scene_.time_seconds;
  std::optional<std::size_t> const animation = animation_of(scene_), animation_before = animation_of(before);
  if (!animation) return;
  bool const is_known = animation_before && before.file == scene_.file;
  playback_ = Playback(scene_.loaded->contents()->animations[*animation].seconds, scene_.time_seconds);
  if (is_known && animation != animation_before) playback_.go_to(0);
  if (is_known && animation == animation_before && last.has_begun()) playback_.go_to(last.time());
  if (last.is_playing()) playback_.play(glfwGetTime());
}

void Window::advance_animation() {
  playback_.advance(glfwGetTime());
  if (is_pose_awaited_ || !playback_.has_begun() || playback_.time() == posed_time_) return;
  posed_time_ = playback_.time();
  is_pose_awaited_ = true;
  worker_->pose(scene_.number, playback_.time());
}

void Window::take_pose(PosedView posed) {
  is_pose_awaited_ = false;
  bool const is_lens_set = has_other_lens(scene_.request.camera);
  scene_.request = std::move(posed.request);
  scene_.cameras = std::move(posed.cameras);
  scene_.bounds = posed.bounds;
  has_marking_ = false;
  if (is_moved_ || !scene_.has_own_cameras) return;
  Camera const& camera = scene_.request.camera;
  is_lens_set ? look_from(camera, scene_.request.resolution) : look_through(camera, scene_.request.resolution);
  show();
}

void Window::handle_animation_key(int key) {
  double const frame_rate = options_.render.frame_rate();
  if (key == GLFW_KEY_SPACE && playback_.is_playing()) {
    playback_.pause();
  } else if (key == GLFW_KEY_SPACE) {
    playback_.play(glfwGetTime());
  }
  if (key == GLFW_KEY_RIGHT) playback_.step(1, frame_rate);
  if (key == GLFW_KEY_LEFT) playback_.step(-1, frame_rate);
  if (key == GLFW_KEY_HOME) playback_.go_to(0);
}

void Window::choose_animation(std::size_t number) {
  if (number == *scene_.loaded->contents()->animation) return;
  if (warns_of_edits("an animation that is chosen again is shown without it")) return;
  worker_->choose_animation(scene_.number, number);
}

float Window::draw_time_line() {
  if (playback_.duration() == 0) return 0;
  ModelContents const& contents = *scene_.loaded->contents();
  ImVec2 const area = ImGui::GetIO().DisplaySize;
  float const left = panel_width(), width = area.x - left;
  ImGui::SetNextWindowPos({left + width / 2, area.y - scaled(8)}, ImGuiCond_Always, {0.5f, 1});
  ImGui::SetNextWindowBgAlpha(0.6f);
  ImGui::Begin("time line", nullptr, overlay);
  if (ImGui::Button(playback_.is_playing() ? "pause" : "play ", {scaled(48), 0})) handle_animation_key(GLFW_KEY_SPACE);
  ImGui::SameLine();
  float time = float(playback_.time());
  std::string const shown =
      fmt::format("{} {:.2f} s", playback_.has_begun() ? "%.2f of" : "at rest,", playback_.duration());
  bool const are_several = contents.animations.size() > 1;
  bool const are_beside = are_several && width >= scaled(320);  // the time; else below it
  ImGui::SetNextItemWidth(std::clamp(width - scaled(are_beside ? 230 : 110), scaled(60), scaled(400)));
  bool const is_moved = ImGui::SliderFloat("##time", &time, 0, float(playback_.duration()), shown.c_str());
  if (is_moved || ImGui::IsItemActivated()) playback_.go_to(double(time));
  if (are_several) {
    if (are_beside) ImGui::SameLine();
    ImGui::SetNextItemWidth(scaled(110));
    if (ImGui::BeginCombo("##animation",
                          label_of(contents.animations[*contents.animation], *contents.animation).c_str())) {
      for (std::size_t i = 0; i < contents.animations.size(); ++i) {
        ImGui::PushID(int(i));
        if (ImGui::Selectable(label_of(contents.animations[i], i).c_str(), i == *contents.animation)) {
          choose_animation(i);
        }
        ImGui::PopID();
      }
      ImGui::EndCombo();
    }
  }
  float const height = ImGui::GetWindowHeight();
  ImGui::End();
  return height;
}

}  // namespace lichtraum::view
