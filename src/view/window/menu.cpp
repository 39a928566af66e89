#include "view/window/menu.hpp"

#include <GLFW/glfw3.h>
#include <imgui.h>

namespace lichtraum::view {
namespace {

struct Entry {
  char const* label;
  char const* key_name;
  char32_t character;  // which is typed; 0: a key
  int key = 0;
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
    {"Turn right", "Right", 0, GLFW_KEY_RIGHT},
    {"Turn left", "Left", 0, GLFW_KEY_LEFT},
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
void draw_menu(char const* name, Entry const (&entries)[count], Graphics& graphics) {
  if (!ImGui::BeginMenu(name)) return;
  for (Entry const& entry : entries) {
    if (!ImGui::MenuItem(entry.label, entry.key_name)) continue;
    if (entry.character != 0) {
      graphics.characters.push_back(entry.character);
    } else {
      graphics.keys.push_back({entry.key});
    }
    glfwPostEmptyEvent();  // it is done in the next turn of the window's loop, which must not wait
  }
  ImGui::EndMenu();
}

}  // namespace

void draw_menus(Graphics& graphics, bool has_animation) {
  if (!ImGui::BeginMenuBar()) return;
  draw_menu("File", file_entries, graphics);
  draw_menu("View", view_entries, graphics);
  if (has_animation) draw_menu("Animation", animation_entries, graphics);
  draw_menu("Help", help_entries, graphics);
  ImGui::EndMenuBar();
}

}  // namespace lichtraum::view
