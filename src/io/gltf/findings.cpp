#include "io/gltf/findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace lichtraum::gltf {
namespace {

constexpr std::size_t max_findings = 100;

Diagnostic make(Severity severity, DiagnosticCode code, std::string const& file, std::string_view pointer,
                std::string_view message) {
  Diagnostic diagnostic;
  diagnostic.severity = severity;
  diagnostic.code = code;
  diagnostic.location.file = file;
  diagnostic.message = pointer.empty() ? std::string(message) : fmt::format("{}: {}", pointer, message);
  return diagnostic;
}

}  // namespace

void Findings::warn(DiagnosticCode code, std::string_view pointer, std::string_view message) {
  if (is_muted_) return;
  Diagnostic found = make(Severity::warning, code, file_, pointer, message);
  bool const is_known =
      std::ranges::any_of(diagnostics_, [&](Diagnostic const& known) { return known.message == found.message; });
  if (is_known) return;
  if (diagnostics_.size() < max_findings) {
    diagnostics_.push_back(std::move(found));
  } else {
    ++dropped_;
  }
}

void Findings::fail(DiagnosticCode code, std::string_view pointer, std::string_view message) {
  std::vector<Diagnostic> all = take();
  all.push_back(make(Severity::error, code, file_, pointer, message));
  throw SceneError(std::move(all));
}

void Findings::fail_at(DiagnosticCode code, std::string_view text, std::size_t offset, std::string_view message) {
  std::string_view const before = text.substr(0, std::min(offset, text.size()));
  std::size_t const line_begin = before.rfind('\n') + 1;  // npos + 1 is 0
  std::vector<Diagnostic> all = take();
  all.push_back(make(Severity::error, code, file_, "", message));
  all.back().location.line = 1 + std::size_t(std::count(before.begin(), before.end(), '\n'));
  all.back().location.column = before.size() - line_begin + 1;
  throw SceneError(std::move(all));
}

std::vector<Diagnostic> Findings::take() {
  if (dropped_ > 0) {
    diagnostics_.push_back(make(Severity::warning, DiagnosticCode::too_many_findings, file_, "",
                                fmt::format("and {} more findings", dropped_)));
    dropped_ = 0;
  }
  return std::move(diagnostics_);
}

}  // namespace lichtraum::gltf
