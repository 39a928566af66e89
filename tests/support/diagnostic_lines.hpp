#pragma once

#include <string>
#include <vector>

#include "lichtraum/error.hpp"

namespace lichtraum::test {

/// The messages of all, a line each.
inline std::string message_lines(std::vector<Diagnostic> const& diagnostics) {
  std::string all;
  for (auto const& d : diagnostics) all += d.message + "\n";
  return all;
}

/// The same with the places before them: "line:column: message".
inline std::string placed_message_lines(std::vector<Diagnostic> const& diagnostics) {
  std::string all;
  for (auto const& d : diagnostics) {
    all += std::to_string(d.location.line) + ":" + std::to_string(d.location.column) + ": " + d.message + "\n";
  }
  return all;
}

}  // namespace lichtraum::test
