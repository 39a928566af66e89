#pragma once

#include <string>
#include <string_view>

#include "lichtraum/light.hpp"
#include "lichtraum/material.hpp"

namespace lichtraum::view {

/// A name as one word of eSDF. Names of models may be any text: what is no letter, digit, '.', '-' or '_' in them turns
/// into '_'; an empty one is "unnamed".
std::string word_of(std::string name);

/// The statement that defines this material in eSDF under that name, which is one word of eSDF. Of glTF's model it is
/// Phong's coefficients without textures, as eSDF has no other.
std::string material_statement(std::string_view name, Material const& material);

/// The same of a light; a comment that says so where eSDF has no such light.
std::string light_statement(std::string_view name, Light const& light);

/// To be copied: a line of its own, with word_of the name.
std::string material_as_esdf(Material const& material);
std::string light_as_esdf(Light const& light);

}  // namespace lichtraum::view
