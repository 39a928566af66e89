#include "view/window/graphics.hpp"

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "lichtraum/error.hpp"
#include "view/window/font.hpp"

namespace lichtraum::view {
namespace {

Graphics& graphics_of(GLFWwindow* window) { return *static_cast<Graphics*>(glfwGetWindowUserPointer(window)); }

[[noreturn]] void no_display() {
  throw Error(ErrorKind::unavailable,
              "there is no display with OpenGL 3.3 to open a window on (lichtraum preview shows a scene in the "
              "terminal)");
}

bool is_arrow(int key) {
  return key == GLFW_KEY_LEFT || key == GLFW_KEY_RIGHT || key == GLFW_KEY_UP || key == GLFW_KEY_DOWN;
}

/// GLFW 3.4 tries Wayland too, whose library prints a line of its own where it cannot have a socket.
void leave_out_hopeless_platforms() {
#ifdef GLFW_PLATFORM
  char const* const display = std::getenv("WAYLAND_DISPLAY");
  bool const may_have_socket = std::getenv("XDG_RUNTIME_DIR") || (display && display[0] == '/');
  if (!may_have_socket) glfwInitHint(GLFW_PLATFORM, GLFW_PLATFORM_X11);
#endif
}

}  // namespace

float scaled(float length) { return length * ImGui::GetFontSize() / own_font_height; }

void ShownPicture::upload(Resolution const& new_size, std::vector<unsigned char> const& pixels) {
  if (texture == 0) glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  if (new_size != size) {
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, new_size.width, new_size.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 pixels.data());
  } else {
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, size.width, size.height, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  }
  size = new_size;
}

Graphics::Graphics() {
  glfwSetErrorCallback([](int, char const*) {});
  leave_out_hopeless_platforms();
  if (glfwInit() != GLFW_TRUE) no_display();
}

Graphics::~Graphics() {
  if (window) {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
  }
  glfwTerminate();
}

void Graphics::open(std::string const& title, Resolution const& size, std::optional<double> ui_scale) {
  given_ui_scale_ = ui_scale;
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  // What desktops find lichtraum.desktop by, and with it the icon.
  glfwWindowHintString(GLFW_X11_CLASS_NAME, "lichtraum");
  glfwWindowHintString(GLFW_X11_INSTANCE_NAME, "lichtraum");
#ifdef GLFW_WAYLAND_APP_ID  // since GLFW 3.4
  glfwWindowHintString(GLFW_WAYLAND_APP_ID, "lichtraum");
#endif
  window = glfwCreateWindow(size.width, size.height, title.c_str(), nullptr, nullptr);
  if (!window) no_display();
  glfwMakeContextCurrent(window);
  glfwSwapInterval(0);
  glfwSetWindowUserPointer(window, this);
  // Dear ImGui, below, hands on what it gets to these.
  glfwSetCharCallback(window, [](GLFWwindow* w, unsigned character) {
    if (graphics_of(w).is_key_held && !(character == '+' || character == '-')) return;
    bool const is_capital = character >= 'A' && character <= 'Z';
    graphics_of(w).characters.push_back(is_capital ? character - 'A' + 'a' : character);
  });
  glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int, int action, int modifiers) {
    bool& is_held = graphics_of(w).is_key_held;
    is_held = action == GLFW_REPEAT;  // of the character as well, which comes next
    if (action == GLFW_RELEASE || (is_held && !is_arrow(key))) return;
    graphics_of(w).keys.push_back({key, (modifiers & GLFW_MOD_SHIFT) != 0});
  });
  glfwSetDropCallback(window, [](GLFWwindow* w, int count, char const** files) {
    graphics_of(w).dropped.assign(files, files + count);
  });
  glfwSetWindowCloseCallback(window, [](GLFWwindow* w) {
    glfwSetWindowShouldClose(w, GLFW_FALSE);
    graphics_of(w).is_close_asked = true;
  });
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;
  ImGui_ImplGlfw_InitForOpenGL(window, true);
  ImGui_ImplOpenGL3_Init("#version 330");
  fit_to_display();
}

void Graphics::fit_to_display() {
  float content_scale = 1, unused = 1;
  glfwGetWindowContentScale(window, &content_scale, &unused);
  int width = 0, width_then = 0, unused_height = 0;
  glfwGetWindowSize(window, &width, &unused_height);
  int const pixels = framebuffer_size().width;
  glfwGetWindowSize(window, &width_then, &unused_height);
  if (width_then != width) return;  // it is being resized: the two do not belong together
  // Where a window is measured in larger units than pixels, those are Dear ImGui's.
  float const pixels_per_unit = width > 0 ? std::clamp(float(pixels) / float(width), 0.5f, 8.f) : 1;
  auto const scale = float(given_ui_scale_.value_or(std::clamp(double(content_scale / pixels_per_unit), 0.5, 8.0)));
  if (scale == ui_scale_ && pixels_per_unit == pixels_per_unit_) return;
  ui_scale_ = scale;
  pixels_per_unit_ = pixels_per_unit;
  load_font(std::round(own_font_height * scale * pixels_per_unit));
  ImGui::GetIO().FontGlobalScale = 1 / pixels_per_unit;
  ImGui_ImplOpenGL3_DestroyFontsTexture();  // it is made again with the next frame
  ImGui_ImplOpenGL3_CreateFontsTexture();
  ImGui::GetStyle() = ImGuiStyle();
  ImGui::GetStyle().ScaleAllSizes(scale);
}

Resolution Graphics::framebuffer_size() const {
  int width = 0, height = 0;
  glfwGetFramebufferSize(window, &width, &height);
  return {std::max(1, width), std::max(1, height)};
}

Resolution Graphics::fitting(Resolution const& size) {
  int x = 0, y = 0, width = 0, height = 0;
  if (GLFWmonitor* const monitor = glfwGetPrimaryMonitor()) glfwGetMonitorWorkarea(monitor, &x, &y, &width, &height);
  bool const is_known = width > 0 && height > 0;
  return is_known ? Resolution{std::min(size.width, width), std::min(size.height, height)} : size;
}

void Graphics::resize(Resolution const& size) const {
  Resolution const fitted = fitting(size);
  glfwSetWindowSize(window, fitted.width, fitted.height);
}

void Graphics::begin_drawing() {
  fit_to_display();
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  ImGui::NewFrame();
}

void Graphics::show_drawing() const {
  Resolution const size = framebuffer_size();
  glViewport(0, 0, size.width, size.height);
  glClear(GL_COLOR_BUFFER_BIT);
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
  glfwSwapBuffers(window);
}

}  // namespace lichtraum::view
