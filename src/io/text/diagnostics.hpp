#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "io/text/lines.hpp"
#include "lichtraum/error.hpp"

namespace lichtraum {

/// 'blue', cut when it is long: a name in a file may be a megabyte.
std::string in_quotes(std::string_view token);

/// Everything between two tokens of one line, both included.
Token span_of(Token first, Token last);

/// The empty place just after a token, where something is missing.
Token place_after(Token token);

/// Collects what is found in one file: at most `limit` findings, errors before warnings before notes.
class Diagnostics {
 public:
  Diagnostics(std::string file, std::size_t limit) : file_(std::move(file)), limit_(limit > 0 ? limit : 1) {}

  void begin_line(Line const& line) { line_ = line; }
  Line const& line() const { return line_; }

  /// `at` is a part of the current line; an empty `at` outside of it stands for the whole line or file. Notes are kept
  /// without their code.
  void add(Severity severity, DiagnosticCode code, Token at, std::string message, std::string hint = {});

  /// The finding that was added last, for add_again; no_finding if there was no room for it.
  std::size_t last() const { return last_; }
  static constexpr std::size_t no_finding = static_cast<std::size_t>(-1);
  /// Counts a finding again in the current line, instead of adding one: "(and in 3 more lines)".
  void add_again(std::size_t finding);

  std::size_t count(Severity severity) const { return counts_[static_cast<std::size_t>(severity)]; }
  std::size_t errors() const { return count(Severity::error); }
  /// Whether a further error would only be counted, so that nobody need think about a hint.
  bool has_all_errors() const { return errors() >= limit_; }

  /// The findings by line; when there were more than the limit, a last warning says how many are not shown. When
  /// `stopped_at` is not 0, that warning says that the file was not checked from that line on.
  std::vector<Diagnostic> finish(std::size_t stopped_at) &&;

 private:
  std::string file_;
  std::size_t limit_;
  Line line_;
  std::array<std::size_t, 3> counts_{};  // by Severity
  /// Lines after the one of a finding in which it was again.
  struct MoreLines {
    std::size_t count = 0;
    std::size_t last = 0;
  };

  std::vector<Diagnostic> found_;
  std::unordered_map<std::size_t, MoreLines> more_lines_;  // by index in found_
  std::size_t last_ = no_finding;
};

}  // namespace lichtraum
