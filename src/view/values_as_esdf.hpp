#pragma once

#include <string>

#include "lichtraum/light.hpp"
#include "lichtraum/material.hpp"

namespace lichtraum::view {

/// The statement that defines this material in eSDF, with a line break. Of glTF's model it is Phong's coefficients
/// without textures, as eSDF has no other. Of a name, what is no letter, digit, '.', '-' or '_' becomes '_'.
std::string material_as_esdf(Material const& material);

/// The same of a light; a comment that says so where eSDF has no such light.
std::string light_as_esdf(Light const& light);

}  // namespace lichtraum::view
