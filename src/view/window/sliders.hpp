#pragma once

#include "lichtraum/light.hpp"
#include "lichtraum/material.hpp"

namespace lichtraum::view {

/// A slider. `flags`: ImGuiSliderFlags.
bool edit_number(char const* label, double& value, double low, double high, int flags = 0);

/// Widgets for all that may be changed of a light. `original`: as the scene has it; `scene_size` in units of the world.
/// Whether it was.
bool edit_light(Light& light, Light const& original, double scene_size);

/// The same of a material: Phong's coefficients, or those of the physically based model.
bool edit_material(Material& material);

}  // namespace lichtraum::view
