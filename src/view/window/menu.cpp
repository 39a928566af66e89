#include "view/window/menu.hpp"

#include <GLFW/glfw3.h>
#include <imgui.h>

#include <string>

namespace lichtraum::view {
namespace {

struct Entry {
  char const* label;
  char const* key_name;
  char32_t character;  // which is typed; 0: a key
  int key = 0;
  bool needs_shift_beside_animation = false;  // whose frames the key alone goes through
};

constexpr Entry file_entries[] = {
    {"Next file of the folder", "Page Down", 0, GLFW_KEY_PAGE_DOWN},
    {"Previous file", "Page Up", 0, GLFW_KEY_PAGE_UP},
    {"Save the picture", "S", 's'},
    {"Save the changed scene", "W", 'w'},
    {"Copy the camera as eSDF", "C", 'c'},
    {"Close", "Q", 'q'},
};
constexpr Entry view_entries[] = {
    {"Frame what is of interest", "F", 'f'},
    {"The scene's camera", "R", 'r'},
    {"Its first camera (2 ... 9: others)", "1", '1'},
    {"Nearer", "+", '+'},
    {"Farther", "-", '-'},
    {"Turn right", "Right", 0, GLFW_KEY_RIGHT, true},
    {"Turn left", "Left", 0, GLFW_KEY_LEFT, true},
    {"Turn up", "Up", 0, GLFW_KEY_UP},
    {"Turn down", "Down", 0, GLFW_KEY_DOWN},
    {"Picture", "P", 'p'},
    {"Depth", "D", 'd'},
    {"Normals", "N", 'n'},
    {"Objects", "O", 'o'},
    {"Grid", "G", 'g'},
    {"Axes", "X", 'x'},
    {"Edges", "E", 'e'},
    {"Hide this panel", "Tab", 0, GLFW_KEY_TAB},
};
constexpr Entry animation_entries[] = {
    {"Play, or pause", "Space", 0, GLFW_KEY_SPACE},
    {"Next frame", "Right", 0, GLFW_KEY_RIGHT},
    {"Frame before", "Left", 0, GLFW_KEY_LEFT},
    {"Start", "Home", 0, GLFW_KEY_HOME},
};
constexpr Entry help_entries[] = {{"Keys and mouse", "?", '?'}};

template <std::size_t count>
void draw_menu(char const* name, Entry const (&entries)[count], Graphics& graphics, bool has_animation) {
  if (!ImGui::BeginMenu(name)) return;
  for (Entry const& entry : entries) {
    bool const with_shift = has_animation && entry.needs_shift_beside_animation;
    std::string const keys = std::string(with_shift ? "Shift+" : "") + entry.key_name;
    if (!ImGui::MenuItem(entry.label, keys.c_str())) continue;
    if (entry.character != 0) {
      graphics.characters.push_back(entry.character);
    } else {
      graphics.keys.push_back({entry.key, with_shift});
    }
    glfwPostEmptyEvent();  // it is done in the next turn of the window's loop, which must not wait
  }
  ImGui::EndMenu();
}

}  // namespace

void draw_menus(Graphics& graphics, bool has_animation) {
  if (!ImGui::BeginMenuBar()) return;
  draw_menu("File", file_entries, graphics, has_animation);
  draw_menu("View", view_entries, graphics, has_animation);
  if (has_animation) draw_menu("Animation", animation_entries, graphics, has_animation);
  draw_menu("Help", help_entries, graphics, has_animation);
  ImGui::EndMenuBar();
}

}  // namespace lichtraum::view
