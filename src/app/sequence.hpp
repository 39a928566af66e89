#pragma once

#include <string>
#include <vector>

#include "app/console.hpp"
#include "app/render_options.hpp"
#include "app/render_statistics.hpp"

namespace lichtraum::app {

/// Draws the pictures of all inputs, in order, to files or into a film: while one is traced, the next is loaded and the
/// one before is written. Says on the console what went wrong with an input and goes on with the next, unless it is a
/// film. Returns the process's exit code: that of the first failure.
int draw_sequence(std::vector<std::string> const& inputs, RenderOptions const& options, OutputNames& names,
                  Renderer& renderer, Console const& console, RunReport& report);

}  // namespace lichtraum::app
