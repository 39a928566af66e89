#pragma once

#include <exception>
#include <string>

#include "lichtraum/error.hpp"

namespace lichtraum::view {

/// What a window says of why something could not be read: of a scene's diagnostics those that the terminal shows too,
/// so none that only notes a dialect.
inline std::string problem_text(std::exception const& problem) {
  auto const* const scene = dynamic_cast<SceneError const*>(&problem);
  if (!scene) return problem.what();
  std::string text;
  for (Diagnostic const& diagnostic : scene->diagnostics()) {
    if (diagnostic.severity != Severity::note) text += format_diagnostic(diagnostic);
  }
  return text;
}

}  // namespace lichtraum::view
