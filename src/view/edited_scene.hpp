#pragma once

#include <string>
#include <string_view>

#include "view/scene_values.hpp"

namespace lichtraum::view {

/// The text of a scene in which the statements that define edited lights, materials and the environment are new; all
/// else stays to the byte, as comments and line breaks. Throws Error{cannot_create} where an edited one has no line of its own in the text, or one that
/// chooses the tone map as well, and when nothing was edited.
std::string edited_scene(std::string_view text, SceneValues const& values);

}  // namespace lichtraum::view
