#pragma once

#include "lichtraum/renderer.hpp"

namespace lichtraum {

/// Throws Error{usage} that says what makes no sense: a picture without pixels, a region outside it, no samples, a grid
/// whose count is not square, a negative depth, an environment to see without one.
void check_request(RenderRequest const& request);

}  // namespace lichtraum
