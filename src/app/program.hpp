#pragma once

#include <functional>

#include "app/console.hpp"

namespace lichtraum::app {

/// The frame around a program's work: signals, standard streams that are there, and every exception as a message and an
/// exit code.
int run_program(std::function<int(Console&)> const& work);

}  // namespace lichtraum::app
