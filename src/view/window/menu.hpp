#pragma once

#include "view/window/graphics.hpp"

namespace lichtraum::view {

/// All that keys do, with the keys beside it, as menus in the menu bar of the current Dear ImGui window. What is chosen
/// is done as if its key had been pressed. `has_animation`: with what plays it.
void draw_menus(Graphics& graphics, bool has_animation);

}  // namespace lichtraum::view
