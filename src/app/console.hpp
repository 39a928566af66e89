#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lichtraum/error.hpp"

namespace lichtraum::app {

/// `silent`: nothing but faults, for what is told in another way.
enum class Verbosity { silent, quiet, normal, verbose };

/// What the program says while it works. All of it goes to standard error: standard output is for results. Coloured on
/// a terminal, unless NO_COLOR is set (https://no-color.org).
class Console {
 public:
  /// `command_line` is what reports of faults tell: the program's name and its arguments.
  explicit Console(std::vector<std::string> command_line = {});

  void set_verbosity(Verbosity verbosity) { verbosity_ = verbosity; }
  bool is_verbose() const { return verbosity_ == Verbosity::verbose; }
  bool is_quiet() const { return verbosity_ <= Verbosity::quiet; }
  bool is_terminal() const { return is_terminal_; }

  void data(std::string_view text) const;        ///< as it is, always
  void error(std::string_view message) const;    ///< not when silent
  void warning(std::string_view message) const;  ///< not with --quiet
  void info(std::string_view message) const;     ///< not with --quiet
  void detail(std::string_view message) const;   ///< only with --verbose

  /// Errors unless silent, warnings unless --quiet, notes only with --verbose. What is of no file is the program's.
  void show(std::vector<Diagnostic> const& diagnostics) const;
  /// A scene's diagnostics, the message of others; a report of a fault for ErrorKind::internal.
  void show(Error const& error) const;
  /// A report for an exception that nobody expected.
  void fault(std::string_view what) const;

 private:
  void labelled(std::string_view label, std::string_view color, std::string_view message) const;

  std::vector<std::string> command_line_;
  bool is_terminal_;
  bool is_colored_;
  Verbosity verbosity_ = Verbosity::normal;
};

/// To standard output, at once. Throws Error{io} when it is closed or full.
void write_standard_output(std::string_view bytes);

/// Whether it was closed when the program began, so that nothing can be written there.
bool is_standard_output_closed();

}  // namespace lichtraum::app
