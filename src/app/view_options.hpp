#pragma once

#include <optional>
#include <string>

#include <CLI/App.hpp>

#include "app/commands.hpp"
#include "app/render_options.hpp"

namespace lichtraum::app {

/// What `lichtraum view` is asked for.
struct ViewOptions {
  std::string scene;
  RenderOptions render;
  bool watch = false;
  std::optional<double> ui_scale;  ///< of text and widgets; nothing: the display's
};

/// Returns false when only the help was wanted. Throws Error{usage}.
bool parse_view(Arguments const& arguments, ViewOptions& options, Console& console);

/// Of what was given to another command's parser, what `lichtraum view` knows as well.
Arguments arguments_for_view(CLI::App const& parser);

/// Makes this process the window's program. Throws Error{unavailable} when there is none.
[[noreturn]] void become_window(Arguments const& arguments);

}  // namespace lichtraum::app
