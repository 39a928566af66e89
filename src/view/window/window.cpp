#include "view/window/window.hpp"

#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "core/counted.hpp"
#include "view/window/keys.hpp"
#include "view/window/menu.hpp"

namespace lichtraum::view {
namespace {

constexpr Resolution default_size{960, 640};
/// At most so often, unless there is a new picture: drawing takes time from tracing.
constexpr double seconds_between_draws = 0.03;
/// When nothing happens.
constexpr double seconds_between_looks = 1;

/// Along the camera's axis; of what is not before it, as the crow flies.
double distance_ahead(Camera const& camera, Vec3 const& point) {
  Vec3 const eye = camera.world_from_camera().point(Vec3(0));
  double const ahead = glm::dot(point - eye, glm::normalize(camera.world_from_camera().vector({0, 0, -1})));
  if (ahead > 0) return ahead;
  double const distance = glm::distance(point, eye);
  return distance > 0 ? distance : 1;
}

/// A point that the camera shows sharp; without a lens, `center`.
Vec3 focus_of(Camera const& camera, Vec3 const& center) {
  if (camera.lens().aperture == 0) return center;
  Vec3 const ahead = glm::normalize(camera.world_from_camera().vector({0, 0, -1}));
  return camera.world_from_camera().point(Vec3(0)) + camera.lens().focus_distance * ahead;
}

}  // namespace

Window::Window(app::SceneSource const& source, app::ViewOptions const& options, app::Console const& console)
    : options_(options), console_(console), files_(source.name()) {
  graphics_ = std::make_unique<Graphics>();
  Resolution const wanted = options.render.job.size.value_or(default_size), size = Graphics::fitting(wanted);
  if (options.render.job.size && size != wanted) {
    console.warning(
        fmt::format("--size: the window is {}x{}, all that the screen has room for", size.width, size.height));
  }
  graphics_->open("lichtraum - " + source.name(), size, options.ui_scale);
  // Not before the window is there: Mesa and PoCL may share one LLVM, which does not start in two threads at once.
  worker_ = std::make_unique<Worker>(source, options.render, options.watch, console, glfwPostEmptyEvent);
}

Window::~Window() {
  glfwHideWindow(graphics_->window);  // what is being read is read to its end
  worker_.reset();
}

void Window::run() {
  int draws_due = 1;
  double drawn_at = 0;
  while (glfwWindowShouldClose(graphics_->window) == GLFW_FALSE) {
    double const patience = draws_due > 0 ? seconds_between_draws : seconds_between_looks;
    double const start = glfwGetTime();
    glfwWaitEventsTimeout(patience);
    // Dear ImGui takes a move and a click one after the other, and what they do is seen in the drawing after that.
    if (glfwGetTime() - start < patience) draws_due = 4;
    bool const has_news = take_news();
    graphics_->begin_drawing();
    dismiss_messages();
    if (std::exchange(graphics_->is_close_asked, false)) close();
    open_dropped();
    handle_mouse();
    handle_keys();
    advance_animation();
    if (!awaited_.empty() && glfwGetTime() - drawn_at >= seconds_between_looks) draws_due = 1;  // its seconds are shown
    if (playback_.is_playing()) draws_due = std::max(draws_due, 1);
    if (camera_ && picture_size() != shown_size_) show();
    draw();
    ImGui::Render();
    if (!has_news && glfwGetTime() - drawn_at < seconds_between_draws) continue;
    --draws_due;
    drawn_at = glfwGetTime();
    graphics_->show_drawing();
  }
}

bool Window::take_news() {
  Worker::News news = worker_->news();
  if (!news.device.empty()) device_ = news.device;
  if (news.problem) {
    awaited_.clear();
    problem_ = *news.problem;
    is_pose_awaited_ = false;
    if (!problem_.empty()) {
      playback_.pause();
      console_.data(problem_ + "\n");
    }
    skip(problem_);
  }
  if (news.scene) {
    awaited_.clear();
    bool const is_first = !camera_;
    if (news.scene->file != scene_.file) is_moved_ = saves_when_whole_ = false;
    SceneView const before = std::exchange(scene_, std::move(*news.scene));
    if (overlays_.up != scene_.up) {
      overlays_.up = scene_.up;
      view_number_ = worker_->overlay(overlays_);
    }
    if (is_first && !options_.render.job.size) {
      Resolution const& picture = scene_.request.resolution;
      int const panel = int(panel_width_beside(float(picture.width), graphics_->ui_scale()));
      graphics_->resize({picture.width + panel, picture.height});
    }
    glfwSetWindowTitle(graphics_->window, ("lichtraum - " + scene_.file).c_str());
    panel_.set_scene(scene_);
    has_unsaved_edits_ = false;
    begin_animation(before);
    focus_ = focus_of(scene_.request.camera, center_of_interest());
    mark_selection();  // of nothing: what was selected was of the scene before
    if (!is_moved_) look_from(scene_.request.camera, scene_.request.resolution);
    show();
  }
  if (news.posed && news.posed->scene_number == scene_.number) take_pose(std::move(*news.posed));
  if (news.edited && news.edited->scene_number == scene_.number) {
    scene_.request = std::move(news.edited->request);
    show();
  }
  if (news.frame) {
    frame_ = std::move(*news.frame);
    graphics_->picture.upload(frame_->image.size(), frame_->pixels);
    if (saves_when_whole_ && is_picture_whole()) save();
  }
  if (news.marking) {
    has_marking_ = true;
    graphics_->marking.upload(news.marking->size, news.marking->pixels);
  }
  if (news.look && news.look->scene_number == scene_.number) {
    if (panel_.select(news.look->seen)) mark_selection();
    if (news.look->seen && panel_.aperture > 0) {
      focus_ = news.look->seen->position;
      show();
    }
  }
  return news.look || news.marking || news.frame || news.problem || news.scene || news.posed || news.edited;
}

void Window::skip(std::string const& problem) {
  if (problem.empty()) {
    files_.arrive();
    problem_ = std::exchange(skipped_, {});
    return;
  }
  auto const other = files_.skip();
  if (other) open(*other);
  skipped_ = other ? problem : "";
}

void Window::open(std::filesystem::path const& file) {
  awaited_ = file.filename().string();
  awaited_since_ = glfwGetTime();
  worker_->open(file);
}

void Window::open_dropped() {
  if (graphics_->dropped.empty()) return;
  std::vector<std::string> const dropped = std::exchange(graphics_->dropped, {});
  if (warns_of_edits("a file that is dropped again is opened without it")) return;
  if (dropped.size() > 1) tell("of the files that were dropped, the first is opened", seconds_to_read);
  files_.open(dropped.front());
  open(files_.file());
}

void Window::step(int direction) {
  if (warns_of_edits("Page Down and Page Up go on without it")) return;
  if (auto const other = files_.step(direction)) open(*other);
}

Camera Window::camera_seen_through() const {
  Camera camera = camera_->camera();
  camera.set_lens({panel_.aperture, distance_ahead(camera, focus_)});
  return camera;
}

void Window::look_from(Camera const& camera, Resolution const& made_for) {
  camera_.emplace(camera, center_of_interest(), made_for, scene_.up, radius_of_interest());
}

void Window::look_through(Camera const& camera, Resolution const& made_for) {
  look_from(camera, made_for);
  panel_.aperture = camera.lens().aperture;
  focus_ = focus_of(camera, center_of_interest());
}

bool Window::has_other_lens(Camera const& camera) const {
  return panel_.aperture != camera.lens().aperture || focus_ != focus_of(camera, center_of_interest());
}

Vec3 Window::center_of_interest() const { return scene_.bounds.is_empty() ? Vec3(0) : scene_.bounds.center(); }

double Window::radius_of_interest() const {
  double const radius = scene_.bounds.is_empty() ? 0 : 0.5 * glm::distance(scene_.bounds.min, scene_.bounds.max);
  return std::isfinite(radius) ? radius : 0;
}

void Window::show() {
  shown_size_ = picture_size();
  camera_->fit_to(shown_size_);
  RenderRequest view = scene_.request;
  view.camera = camera_seen_through();
  view.resolution = shown_size_;
  view.planes = {panel_.plane};
  has_marking_ = false;
  view_number_ = worker_->show(view);
}

void Window::show(FilmPlane plane) {
  panel_.plane = plane;
  show();
}

void Window::mark_selection() {
  has_marking_ = false;
  worker_->mark(panel_.selected_objects());
}

bool Window::warns_of_edits(std::string const& way) {
  if (!has_unsaved_edits_ || std::exchange(warned_way_, way) == way) return false;
  bool const is_model = scene_.loaded->is_model();  // whose file nobody writes
  tell(fmt::format("what was changed is not saved: {}{}", is_model ? "" : "W saves it as a new file, ", way),
       until_dismissed);
  return true;
}

void Window::close() {
  if (warns_of_edits("Q or Esc closes without it")) return;
  glfwSetWindowShouldClose(graphics_->window, GLFW_TRUE);
}

bool Window::close_topmost() {
  if (ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopup)) {
    ImGui::SetWindowFocus(nullptr);  // closes them all
    return true;
  }
  return std::exchange(is_help_open_, false);
}

void Window::choose_camera(std::size_t number) {
  if (number >= scene_.cameras.size()) return;
  is_moved_ = true;
  Camera const& camera = scene_.cameras[number];
  Resolution const made_for = camera.resolution().value_or(scene_.request.resolution);
  look_through(camera.fitted(made_for), made_for);
  show();
}

void Window::frame_everything() {
  if (scene_.bounds.is_empty()) return;
  camera_->frame(center_of_interest(), radius_of_interest(), shown_size_);
  is_moved_ = true;
  show();
}

void Window::tell(std::string text, double seconds) {
  notice_ = std::move(text);
  notice_end_ = glfwGetTime() + seconds;
}

float Window::panel_width() const {
  return is_panel_open_ && camera_ ? std::floor(panel_width_in(ImGui::GetIO().DisplaySize.x, graphics_->ui_scale()))
                                   : 0;
}

Resolution Window::picture_size() const {
  Resolution const all = graphics_->framebuffer_size();
  float const share = panel_width() / std::max(1.0f, ImGui::GetIO().DisplaySize.x);
  return {std::max(1, all.width - int(share * float(all.width) + 0.5f)), all.height};
}

void Window::draw() {
  ImVec2 const area = ImGui::GetIO().DisplaySize;
  float const left = panel_width();
  auto const add = [&](ShownPicture const& picture) {
    auto* const texture = reinterpret_cast<ImTextureID>(std::uintptr_t(picture.texture));
    ImGui::GetBackgroundDrawList()->AddImage(texture, {left, 0}, area);
  };
  if (frame_) add(graphics_->picture);
  if (has_marking_) add(graphics_->marking);
  if (is_panel_open_) draw_panel();
  time_line_height_ = is_panel_open_ ? draw_time_line() : 0;
  if (is_help_open_) draw_keys();
  if (!awaited_.empty()) draw_awaited();
  if (glfwGetTime() >= notice_end_) notice_.clear();
  if (!problem_.empty()) {
    draw_message(problem_, {1, 0.5, 0.4});
  } else if (!notice_.empty()) {
    draw_message(notice_, {1, 1, 1});
  }
}

void Window::draw_message(std::string const& text, Rgb const& color) const {
  ImVec2 const area = ImGui::GetIO().DisplaySize;
  float const left = panel_width(), margin = scaled(8);
  float const bottom = area.y - margin - (time_line_height_ > 0 ? time_line_height_ + margin : 0);
  ImGui::SetNextWindowPos({left + margin, bottom}, ImGuiCond_Always, {0, 1});
  ImGui::SetNextWindowSizeConstraints(
      {0, 0}, {area.x - left - 2 * margin, bottom - margin});  // the first of many mistakes stay in sight
  ImGui::Begin("message", nullptr, overlay | ImGuiWindowFlags_NoInputs);
  ImGui::PushStyleColor(ImGuiCol_Text, {float(color.r), float(color.g), float(color.b), 1});
  ImGui::PushTextWrapPos(area.x - left - 3 * margin);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
  ImGui::End();
}

void Window::draw_awaited() const {
  ImVec2 const area = ImGui::GetIO().DisplaySize;
  float const left = panel_width();
  ImGui::SetNextWindowPos({left + (area.x - left) / 2, area.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::Begin("awaited", nullptr, overlay | ImGuiWindowFlags_NoInputs);
  int const seconds = int(glfwGetTime() - awaited_since_);
  ImGui::TextUnformatted(
      fmt::format("reading {} ...{}", awaited_, seconds > 0 ? fmt::format(" {} s", seconds) : "").c_str());
  ImGui::End();
}

void Window::draw_panel() {
  float const width = ImGui::GetIO().DisplaySize.x, margin = scaled(8);
  ImGui::SetNextWindowPos({width - margin, margin}, ImGuiCond_Always, {1, 0});
  ImGui::SetNextWindowBgAlpha(0.6f);
  ImGui::Begin("statistics", nullptr, overlay | ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoBringToFrontOnFocus);
  ImGui::PushTextWrapPos(width - panel_width() - 3 * margin);
  ImGui::TextUnformatted(statistics().c_str());
  ImGui::PopTextWrapPos();
  ImGui::End();
  Panel::Changes const changes =
      panel_.draw(panel_width(), [this] { draw_menus(*graphics_, playback_.duration() > 0); });
  if (!changes.copied.empty()) copy(changes.copied);
  if (changes.values) {
    view_number_ = worker_->edit(scene_.number, panel_.values().edits());
    has_unsaved_edits_ = panel_.values().is_edited();
    warned_way_.clear();
  }
  if (changes.development) worker_->develop(scene_.number, panel_.development);
  if (changes.selection) mark_selection();
  if (changes.plane || changes.aperture) show();
}

std::string Window::statistics() const {
  if (!frame_) return problem_.empty() ? "loading ..." : "waiting for the file to be saved";
  RenderStatistics const& render = frame_->statistics;
  SceneStatistics const& scene = frame_->scene;
  return fmt::format("{}\n{}x{}, {} per pixel, {:.1f} ms, {:.1f} Mrays/s\n{}, {}, {}, {}\n? shows the keys", device_,
                     frame_->image.width(), frame_->image.height(),
                     counted(std::uint64_t(frame_->pass.sampling.count), "sample"), render.trace_ms,
                     render.trace_ms > 0 ? 1e-3 * double(render.rays.total()) / render.trace_ms : 0.0,
                     counted(scene.triangles, "triangle"), counted(scene.spheres, "sphere"),
                     counted(scene.boxes, "box"), counted(scene.bvh_nodes, "node"));
}

}  // namespace lichtraum::view
