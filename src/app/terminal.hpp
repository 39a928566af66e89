#pragma once

#include <chrono>
#include <optional>

#include "app/terminal_graphics.hpp"

namespace lichtraum::app {

struct TerminalSize {
  int columns = 80;
  int rows = 24;
  /// Of a character, in pixels; what most have when the terminal does not say.
  int cell_width = 10;
  int cell_height = 20;
};

/// Of the terminal that standard output is; nothing when it is not one.
std::optional<TerminalSize> terminal_size();

/// Asks the terminal that standard output is what it can show. One that does not answer in time shows blocks; so does
/// one that cannot be asked, as when the process is in the background.
TerminalGraphics ask_for_graphics(std::chrono::milliseconds timeout);

}  // namespace lichtraum::app
