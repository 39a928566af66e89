#pragma once

#include <string>
#include <vector>

#include "app/render_options.hpp"

namespace lichtraum::python {

/// The options of `lichtraum render` that decide a picture, from words as on its command line: parsed by the same code,
/// so they mean the same, and mistakes get the same messages. Throws Error{usage}.
app::RenderOptions parse_options(std::vector<std::string> const& words);

/// Their names, without the dashes.
std::vector<std::string> option_names();

}  // namespace lichtraum::python
