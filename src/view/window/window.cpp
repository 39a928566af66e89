#include "view/window/window.hpp"

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "lichtraum/image_io.hpp"

namespace lichtraum::view {
namespace {

constexpr Resolution default_size{960, 640};
/// At most so often, unless there is a new picture: drawing takes time from tracing.
constexpr double seconds_between_draws = 0.03;
/// When nothing happens.
constexpr double seconds_between_looks = 1;
constexpr ImGuiWindowFlags overlay = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                                     ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoMove;

}  // namespace

struct Window::Graphics {
  GLFWwindow* window = nullptr;
  GLuint texture = 0;
  Resolution texture_size;
  /// Since they were handled last. Characters rather than keys, so that a keyboard's layout plays no role.
  std::vector<char32_t> characters;
  std::vector<int> keys;

  Graphics() {
    glfwSetErrorCallback([](int, char const*) {});
    if (glfwInit() != GLFW_TRUE) no_display();
  }

  void open(std::string const& title, Resolution const& size) {
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    window = glfwCreateWindow(size.width, size.height, title.c_str(), nullptr, nullptr);
    if (!window) no_display();
    glfwMakeContextCurrent(window);
    glfwSwapInterval(0);
    glfwSetWindowUserPointer(window, this);
    // Dear ImGui, below, hands on what it gets to these.
    glfwSetCharCallback(window, [](GLFWwindow* w, unsigned character) {
      bool const is_capital = character >= 'A' && character <= 'Z';
      of(w).characters.push_back(is_capital ? character - 'A' + 'a' : character);
    });
    glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int, int action, int) {
      if (action != GLFW_RELEASE) of(w).keys.push_back(key);
    });
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;
    ImGui_ImplGlfw_InitForOpenGL(window, true);
    ImGui_ImplOpenGL3_Init("#version 330");
    glGenTextures(1, &texture);
  }

  ~Graphics() {
    if (window) {
      ImGui_ImplOpenGL3_Shutdown();
      ImGui_ImplGlfw_Shutdown();
      ImGui::DestroyContext();
    }
    glfwTerminate();
  }

  static Graphics& of(GLFWwindow* window) { return *static_cast<Graphics*>(glfwGetWindowUserPointer(window)); }

  [[noreturn]] static void no_display() {
    throw Error(ErrorKind::unavailable,
                "there is no display with OpenGL 3.3 to open a window on (lichtraum preview shows a scene in the "
                "terminal)");
  }

  void upload(Frame const& frame) {
    Resolution const size = frame.image.size();
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    if (size != texture_size) {
      glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, size.width, size.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                   frame.pixels.data());
    } else {
      glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, size.width, size.height, GL_RGBA, GL_UNSIGNED_BYTE, frame.pixels.data());
    }
    texture_size = size;
  }
};

Window::Window(app::SceneSource const& source, app::ViewOptions const& options, app::Console const& console)
    : source_(source), options_(options), console_(console) {
  graphics_ = std::make_unique<Graphics>();
  // The device and the scene are looked for while the window is opened.
  worker_ = std::make_unique<Worker>(source, options.render, options.watch, console, glfwPostEmptyEvent);
  graphics_->open("lichtraum - " + source.name(), options.render.size.value_or(default_size));
}

Window::~Window() { worker_.reset(); }

Resolution Window::size() const {
  int width = 0, height = 0;
  glfwGetFramebufferSize(graphics_->window, &width, &height);
  return {std::max(1, width), std::max(1, height)};
}

void Window::run() {
  int draws_due = 1;
  double drawn_at = 0;
  while (glfwWindowShouldClose(graphics_->window) == GLFW_FALSE) {
    double const patience = draws_due > 0 ? seconds_between_draws : seconds_between_looks;
    double const start = glfwGetTime();
    glfwWaitEventsTimeout(patience);
    // What an event does to Dear ImGui's widgets is seen in the drawing after the next one.
    if (glfwGetTime() - start < patience) draws_due = 2;
    bool const has_news = take_news();
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
    handle_mouse();
    handle_keys();
    if (camera_ && size() != shown_size_) show();
    draw();
    ImGui::Render();
    if (!has_news && glfwGetTime() - drawn_at < seconds_between_draws) continue;
    --draws_due;
    drawn_at = glfwGetTime();
    Resolution const framebuffer = size();
    glViewport(0, 0, framebuffer.width, framebuffer.height);
    glClear(GL_COLOR_BUFFER_BIT);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    glfwSwapBuffers(graphics_->window);
  }
}

bool Window::take_news() {
  Worker::News news = worker_->news();
  if (!news.device.empty()) device_ = news.device;
  if (news.problem) {
    problem_ = *news.problem;
    if (!problem_.empty()) console_.data(problem_ + "\n");
  }
  if (news.scene) {
    bool const is_first = !camera_;
    scene_ = std::move(*news.scene);
    if (is_first && !options_.render.size) {
      glfwSetWindowSize(graphics_->window, scene_.request.resolution.width, scene_.request.resolution.height);
    }
    if (!is_moved_) camera_.emplace(scene_.request.camera, scene_.center);
    show();
  }
  if (news.frame) {
    frame_ = std::move(*news.frame);
    graphics_->upload(*frame_);
  }
  return news.frame || news.problem || news.scene;
}

void Window::show() {
  shown_size_ = size();
  RenderRequest view = scene_.request;
  view.camera = camera_->camera();
  view.resolution = shown_size_;
  worker_->show(view);
}

void Window::handle_mouse() {
  ImGuiIO const& io = ImGui::GetIO();
  if (!camera_ || io.WantCaptureMouse) return;
  bool const is_left = ImGui::IsMouseDown(ImGuiMouseButton_Left);
  bool const is_panning = ImGui::IsMouseDown(ImGuiMouseButton_Right) || ImGui::IsMouseDown(ImGuiMouseButton_Middle) ||
                          (is_left && io.KeyShift);
  double const right = io.MouseDelta.x / std::max(1.0f, io.DisplaySize.x);
  double const down = io.MouseDelta.y / std::max(1.0f, io.DisplaySize.x);
  bool moves = false;
  if (is_panning && (right != 0 || down != 0)) {
    camera_->pan(-right, down);
    moves = true;
  } else if (is_left && (right != 0 || down != 0)) {
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
  for (char32_t const character : std::exchange(graphics_->characters, {})) handle_character(character);
  constexpr double step_degrees = 5;
  for (int const key : std::exchange(graphics_->keys, {})) {
    if (key == GLFW_KEY_ESCAPE) close();
    if (key == GLFW_KEY_TAB) is_panel_open_ = !is_panel_open_;
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
  if (character == 's') save();
  if (character == 'c') copy_camera();
  if (character == 'f') frame_everything();
  if (character == 'r') {
    camera_.emplace(scene_.request.camera, scene_.center);
    is_moved_ = false;
    show();
  }
  if (character == '+' || character == '-') {
    camera_->zoom(character == '+' ? 0.9 : 1 / 0.9);
    is_moved_ = true;
    show();
  }
}

void Window::close() { glfwSetWindowShouldClose(graphics_->window, GLFW_TRUE); }

void Window::choose_camera(std::size_t number) {
  if (number >= scene_.cameras.size()) return;
  is_moved_ = true;
  camera_.emplace(scene_.cameras[number], scene_.center);
  show();
}

void Window::frame_everything() {
  if (!(scene_.bounds_min.x <= scene_.bounds_max.x)) return;
  Vec3 const center = 0.5 * (scene_.bounds_min + scene_.bounds_max);
  camera_->frame(center, 0.5 * glm::distance(scene_.bounds_min, scene_.bounds_max), shown_size_);
  is_moved_ = true;
  show();
}

void Window::save() {
  if (!frame_) return;
  for (int number = 1;; ++number) {
    std::string const name = fmt::format("{}_view_{:04}.png", source_.stem(), number);
    if (std::filesystem::exists(name)) continue;
    try {
      write_file_atomically(name, image_format_named("png").encode(frame_->image, {}));
      console_.info(fmt::format("saved {}", name));
    } catch (Error const& error) {
      problem_ = error.what();
      console_.error(error.what());
    }
    return;
  }
}

void Window::copy_camera() const {
  std::string const text = camera_as_esdf(camera_->camera(), shown_size_);
  glfwSetClipboardString(graphics_->window, text.c_str());
  app::write_standard_output(text);  // for those whose clipboard ends with the window
}

void Window::draw() {
  ImVec2 const area = ImGui::GetIO().DisplaySize;
  if (frame_) {
    auto* const texture = reinterpret_cast<ImTextureID>(std::uintptr_t(graphics_->texture));
    ImGui::GetBackgroundDrawList()->AddImage(texture, {0, 0}, area);
  }
  if (is_panel_open_) draw_statistics();
  if (is_help_open_) draw_help();
  if (!problem_.empty()) {
    ImGui::SetNextWindowPos({8, area.y - 8}, ImGuiCond_Always, {0, 1});
    ImGui::Begin("problem", nullptr, overlay | ImGuiWindowFlags_NoInputs);
    ImGui::PushStyleColor(ImGuiCol_Text, {1, 0.5f, 0.4f, 1});
    ImGui::TextUnformatted(problem_.c_str());
    ImGui::PopStyleColor();
    ImGui::End();
  }
}

void Window::draw_statistics() const {
  ImGui::SetNextWindowPos({8, 8});
  ImGui::SetNextWindowBgAlpha(0.6f);
  ImGui::Begin("statistics", nullptr, overlay | ImGuiWindowFlags_NoInputs);
  if (frame_) {
    RenderStatistics const& render = frame_->statistics;
    int const samples = frame_->pass.sampling.count;
    ImGui::Text("%s", device_.c_str());
    ImGui::Text("%dx%d, %d sample%s a pixel, %.1f ms, %.1f Mrays/s", frame_->image.width(), frame_->image.height(),
                samples, samples == 1 ? "" : "s", render.trace_ms,
                render.trace_ms > 0 ? 1e-3 * double(render.rays.total()) / render.trace_ms : 0.0);
    ImGui::Text("%llu triangles, %llu spheres, %llu boxes, %llu nodes",
                static_cast<unsigned long long>(frame_->scene.triangles),
                static_cast<unsigned long long>(frame_->scene.spheres),
                static_cast<unsigned long long>(frame_->scene.boxes),
                static_cast<unsigned long long>(frame_->scene.bvh_nodes));
  } else {
    ImGui::TextUnformatted("loading ...");
  }
  ImGui::TextUnformatted("? shows the keys");
  ImGui::End();
}

void Window::draw_help() const {
  ImVec2 const area = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({area.x / 2, area.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::Begin("keys", nullptr, overlay | ImGuiWindowFlags_NoInputs);
  ImGui::TextUnformatted(
      "left button, arrows    turn around the scene\n"
      "right button, shift    move sideways\n"
      "wheel, + -             nearer, farther\n"
      "R                      the scene's camera\n"
      "1 ... 9                its other cameras\n"
      "F                      show everything\n"
      "S                      save what is seen\n"
      "C                      copy the camera as eSDF\n"
      "Tab                    numbers on, off\n"
      "Q, Esc                 close");
  ImGui::End();
}

}  // namespace lichtraum::view
