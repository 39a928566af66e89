#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "lichtraum/esdf.hpp"
#include "view/scene_values.hpp"

namespace lichtraum::view {

/// The text of a scene in which the statements that define edited lights, materials and the environment are new; all
/// else stays to the byte, as comments and line breaks. Throws Error{cannot_create} where an edited one has no line of
/// its own in the text, more than one, or one that chooses the tone map as well, and when nothing was edited.
std::string edited_scene(std::string_view text, SceneValues const& values);

/// Throws Error{cannot_create} with what is wrong where the text is none of a scene that can be read beside `file`.
void check_readable(std::string const& text, std::filesystem::path const& file, EsdfOptions const& options);

}  // namespace lichtraum::view
