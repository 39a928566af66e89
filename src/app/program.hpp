#pragma once

#include <functional>

#include "app/console.hpp"

namespace lichtraum::app {

/// The frame around a program's work: signals, standard streams that are there, and every exception as a message and an
/// exit code. `command_line` is what a report of a fault shows, see Console.
int run_program(std::vector<std::string> const& command_line, std::function<int(Console&)> const& work);

}  // namespace lichtraum::app
