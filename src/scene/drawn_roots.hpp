#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "lichtraum/scene.hpp"

namespace lichtraum {

/// All roots of the scene, or the shape called `root` alone when that is not empty. Throws Error{usage} for an unknown
/// name, with what was meant, or what there is.
std::vector<std::shared_ptr<Shape const>> drawn_roots(Scene const& scene, std::string_view root);

}  // namespace lichtraum
