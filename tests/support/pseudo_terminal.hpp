#pragma once

#include <string>
#include <utility>
#include <vector>

#include "support/subprocess.hpp"

/// A terminal of a test's own, whose every stream a program gets.
struct PseudoTerminal {
  int columns = 80;
  int rows = 24;
  int cell_width = 0;  ///< pixels of a character; 0: the terminal does not say
  int cell_height = 0;
  /// What it answers (second) once the program has written something (first).
  std::vector<std::pair<std::string, std::string>> answers = {};
};

/// Runs a program in it; what it writes is `out` of the result. Only the process's arguments, folder, environment and
/// timeout count. Throws std::runtime_error as run_process does.
ProcessResult run_in_terminal(PseudoTerminal const& terminal, Process const& process);
