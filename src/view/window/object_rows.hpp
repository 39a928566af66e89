#pragma once

#include "view/object_tree.hpp"
#include "view/scene_values.hpp"

namespace lichtraum::view {

/// The tree's rows in the rest of the current Dear ImGui window, drawn where they are seen only. Whether one was
/// selected. `scrolls`: to the selected row.
bool draw_object_rows(ObjectTree& tree, SceneValues const& values, bool scrolls);

/// "red", or what is said of a shape without a material of its own.
std::string material_name(Shape const& shape, SceneValues const& values);

}  // namespace lichtraum::view
