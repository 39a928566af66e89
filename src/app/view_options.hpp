#pragma once

#include <string>

#include "app/commands.hpp"
#include "app/render_options.hpp"

namespace lichtraum::app {

/// What `lichtraum view` is asked for.
struct ViewOptions {
  std::string scene;
  RenderOptions render;
  bool watch = false;
};

/// Returns false when only the help was wanted. Throws Error{usage}.
bool parse_view(Arguments const& arguments, ViewOptions& options, Console& console);

}  // namespace lichtraum::app
