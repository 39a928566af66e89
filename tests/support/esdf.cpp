#include "support/esdf.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>

#include "support/catch.hpp"

namespace lichtraum::test {

Scene scene_of(std::string const& text, EsdfOptions const& options) {
  INFO(text);
  return EsdfScript::from_text(text, "s.sdf", options).take_scene();
}

std::vector<Diagnostic> findings(std::string const& text, EsdfOptions const& options) {
  try {
    return EsdfScript::from_text(text, "s.sdf", options).diagnostics();
  } catch (SceneError const& error) {
    return error.diagnostics();
  }
}

std::string shown(std::string const& text, EsdfOptions const& options) {
  std::string result;
  for (Diagnostic const& diagnostic : findings(text, options)) {
    bool const is_dialect_note = diagnostic.severity == Severity::note && diagnostic.location.line > 0;
    if (!is_dialect_note) result += format_diagnostic(diagnostic);
  }
  return result;
}

bool loads(std::string const& text, EsdfOptions const& options) {
  try {
    EsdfScript::from_text(text, "s.sdf", options);
    return true;
  } catch (SceneError const&) {
    return false;
  }
}

std::size_t count_errors(std::vector<Diagnostic> const& diagnostics) {
  auto const is_error = [](Diagnostic const& d) { return d.severity == Severity::error; };
  return static_cast<std::size_t>(std::count_if(diagnostics.begin(), diagnostics.end(), is_error));
}

}  // namespace lichtraum::test
