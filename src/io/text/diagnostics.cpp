#include "io/text/diagnostics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <utility>

#include "core/counted.hpp"

namespace lichtraum {
namespace {

constexpr std::size_t longest_quote = 48;          // bytes
constexpr std::size_t longest_line_before = 4096;  // bytes of a line that are kept before the mark ...
constexpr std::size_t longest_line_after = 512;    // ... and after it

bool is_continuation(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

}  // namespace

std::string in_quotes(std::string_view token) {
  if (token.size() <= longest_quote) return fmt::format("'{}'", token);
  std::size_t end = longest_quote - 3;
  while (end > 0 && is_continuation(token[end])) --end;
  return fmt::format("'{}...'", token.substr(0, end));
}

Token span_of(Token first, Token last) {
  return Token(first.data(), static_cast<std::size_t>(last.data() + last.size() - first.data()));
}

Token place_after(Token token) { return Token(token.data() + token.size(), 0); }

void Diagnostics::add(Severity severity, DiagnosticCode code, Token at, std::string message, std::string hint) {
  std::size_t& count = counts_[static_cast<std::size_t>(severity)];
  last_ = no_finding;
  if (++count > limit_) return;

  if (severity == Severity::note) code = DiagnosticCode::none;
  Diagnostic diagnostic{severity, code, {file_, line_.number, 0}, 1, std::move(message), {}, std::move(hint)};
  std::string_view const text = line_.text;
  std::less_equal<char const*> const not_after;  // also for pointers into different texts
  bool const is_in_line =
      at.data() && not_after(text.data(), at.data()) && not_after(at.data() + at.size(), text.data() + text.size());
  if (is_in_line) {
    auto const offset = static_cast<std::size_t>(at.data() - text.data());
    diagnostic.location.column = offset + 1;
    diagnostic.length = std::max<std::size_t>(at.size(), 1);
    // A line may be as long as the file: what is kept of all of them stays small.
    if (offset <= longest_line_before) diagnostic.source_line = text.substr(0, offset + longest_line_after);
    diagnostic.length = std::min(diagnostic.length, longest_line_after);
  } else {
    diagnostic.source_line = text.substr(0, longest_line_after);
  }
  last_ = found_.size();
  found_.push_back(std::move(diagnostic));
}

void Diagnostics::add_again(std::size_t finding) {
  if (finding == no_finding || found_[finding].location.line == line_.number) return;
  MoreLines& more = more_lines_[finding];
  if (more.last == line_.number) return;
  more.last = line_.number;
  ++more.count;
}

std::vector<Diagnostic> Diagnostics::finish(std::size_t stopped_at) && {
  for (auto const& [finding, more] : more_lines_) {
    found_[finding].message += fmt::format(" (and in {})", counted(more.count, "more line"));
  }
  // Notes make room first, then warnings; of each kind the later ones.
  for (Severity const severity : {Severity::note, Severity::warning}) {
    for (std::size_t i = found_.size(); i-- > 0 && found_.size() > limit_;) {
      if (found_[i].severity == severity) found_.erase(found_.begin() + static_cast<std::ptrdiff_t>(i));
    }
  }
  std::stable_sort(found_.begin(), found_.end(), [](Diagnostic const& a, Diagnostic const& b) {
    return std::pair(a.location.line, a.location.column) < std::pair(b.location.line, b.location.column);
  });
  std::array<std::size_t, 3> hidden = counts_;
  for (Diagnostic const& diagnostic : found_) --hidden[static_cast<std::size_t>(diagnostic.severity)];
  auto const hidden_errors = hidden[static_cast<std::size_t>(Severity::error)];
  auto const hidden_warnings = hidden[static_cast<std::size_t>(Severity::warning)];

  std::string message;
  if (stopped_at != 0) {
    message = fmt::format("too many errors: from line {} on the file was not checked", stopped_at);
  } else if (hidden_errors > 0 || hidden_warnings > 0) {
    message = "too many to show: ";
    if (hidden_errors > 0) message += counted(hidden_errors, "more error");
    if (hidden_errors > 0 && hidden_warnings > 0) message += " and ";
    if (hidden_warnings > 0) message += counted(hidden_warnings, "more warning");
  }
  if (!message.empty()) {
    found_.push_back(
        {Severity::warning, DiagnosticCode::too_many_findings, {file_, 0, 0}, 1, std::move(message), {}, {}});
  }
  return std::move(found_);
}

}  // namespace lichtraum
