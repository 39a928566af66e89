#include "view/window/keys.hpp"

#include <algorithm>

namespace lichtraum::view {

void draw_keys() {
  ImVec2 const area = ImGui::GetIO().DisplaySize;
  constexpr char const* keys =
      "left button, arrows    turn around the scene\n"
      "Space                  play an animation, or pause it;\n"
      "Left, Right, Home      its frames one by one, its start\n"
      "                       (Shift and arrows turn it then)\n"
      "right button, shift    move sideways\n"
      "a click                select what is there\n"
      "wheel, + -             nearer, farther\n"
      "R                      the scene's camera\n"
      "1 ... 9                its other cameras\n"
      "F                      show what is of interest\n"
      "G, X, E                grid, axes, edges\n"
      "P, D, N, O             picture, depth, normals, objects\n"
      "Page Down, Page Up     next, previous file of the folder\n"
      "a file dropped here    is opened\n"
      "S                      save what is seen\n"
      "W                      save the changed scene as a new file\n"
      "C                      copy the camera as eSDF\n"
      "Tab                    hide or show the panel\n"
      "Q, Esc                 close";
  ImVec2 const size = ImGui::CalcTextSize(keys), padding = ImGui::GetStyle().WindowPadding;
  float const room = std::min((area.x - 2 * padding.x) / size.x, (area.y - 2 * padding.y) / size.y);
  ImGui::SetNextWindowPos({area.x / 2, area.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::Begin("keys", nullptr, overlay | ImGuiWindowFlags_NoInputs);
  ImGui::SetWindowFontScale(std::clamp(room, 0.3f, 1.0f));  // in a small window as small as it has to be
  ImGui::TextUnformatted(keys);
  ImGui::End();
}

}  // namespace lichtraum::view
