#pragma once

#include <vector>

#include "app/failure_code.hpp"
#include "lichtraum/error.hpp"

namespace lichtraum::app {

/// A scene's own, or one that is of no file.
inline std::vector<Diagnostic> diagnostics_of(Error const& error) {
  if (auto const* const scene_error = dynamic_cast<SceneError const*>(&error)) return scene_error->diagnostics();
  return {{Severity::error, code_of(error.kind()), {}, 1, error.what(), {}, {}}};
}

}  // namespace lichtraum::app
