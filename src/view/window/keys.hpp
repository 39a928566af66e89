#pragma once

#include <imgui.h>

namespace lichtraum::view {

/// Of what lies over the picture and cannot be touched.
inline constexpr ImGuiWindowFlags overlay = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                                            ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                                            ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoMove;

/// What keys and mouse do, in the middle of the window.
void draw_keys();

}  // namespace lichtraum::view
