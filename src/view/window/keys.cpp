#include "view/window/keys.hpp"

namespace lichtraum::view {

void draw_keys() {
  ImVec2 const area = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({area.x / 2, area.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::Begin("keys", nullptr, overlay | ImGuiWindowFlags_NoInputs);
  ImGui::TextUnformatted(
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
      "Q, Esc                 close");
  ImGui::End();
}

}  // namespace lichtraum::view
