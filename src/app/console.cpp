#include "app/console.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "app/failure_code.hpp"
#include "app/fault_report.hpp"
#include "core/write_failure.hpp"

namespace lichtraum::app {
namespace {

constexpr std::string_view red = "\x1b[1;31m";
constexpr std::string_view magenta = "\x1b[1;35m";
constexpr std::string_view cyan = "\x1b[1;36m";
constexpr std::string_view plain = "\x1b[0m";

bool wants_color() {
  char const* const no_color = std::getenv("NO_COLOR");
  char const* const term = std::getenv("TERM");
  return (!no_color || !*no_color) && (!term || std::strcmp(term, "dumb") != 0);
}

void write_standard_error(std::string_view text) { std::fwrite(text.data(), 1, text.size(), stderr); }

struct Label {
  std::string_view word;
  std::string_view color;
};

Label label_of(Severity severity) {
  switch (severity) {
    case Severity::error:
      return {"error:", red};
    case Severity::warning:
      return {"warning:", magenta};
    case Severity::note:
      return {"note:", cyan};
  }
  return {};
}

}  // namespace

Console::Console(std::vector<std::string> command_line)
    : command_line_(std::move(command_line)),
      is_terminal_(::isatty(STDERR_FILENO) == 1),
      is_colored_(is_terminal_ && wants_color()) {}

void Console::labelled(std::string_view label, std::string_view color, std::string_view message) const {
  write_standard_error(is_colored_ ? fmt::format("lichtraum: {}{}{} {}\n", color, label, plain, message)
                                   : fmt::format("lichtraum: {} {}\n", label, message));
}

void Console::data(std::string_view text) const { write_standard_error(text); }

void Console::error(std::string_view message) const {
  if (verbosity_ != Verbosity::silent) labelled("error:", red, message);
}

void Console::warning(std::string_view message) const {
  if (!is_quiet()) labelled("warning:", magenta, message);
}

void Console::info(std::string_view message) const {
  if (!is_quiet()) write_standard_error(fmt::format("{}\n", message));
}

void Console::detail(std::string_view message) const {
  if (is_verbose()) write_standard_error(fmt::format("{}\n", message));
}

void Console::show(std::vector<Diagnostic> const& diagnostics) const {
  for (Diagnostic const& diagnostic : diagnostics) {
    if (verbosity_ == Verbosity::silent || (diagnostic.severity == Severity::warning && is_quiet())) continue;
    if (diagnostic.severity == Severity::note && !is_verbose()) continue;
    std::string text = format_diagnostic(diagnostic);
    if (diagnostic.location.file.empty()) text.insert(0, "lichtraum: ");
    Label const label = label_of(diagnostic.severity);
    std::size_t const place = text.find(label.word);
    if (is_colored_ && place < text.find('\n')) {
      text.insert(place + label.word.size(), plain);
      text.insert(place, label.color);
    }
    write_standard_error(text);
  }
}

void Console::show(Error const& error) const {
  if (auto const* const scene_error = dynamic_cast<SceneError const*>(&error)) {
    show(scene_error->diagnostics());
  } else if (error.kind() == ErrorKind::internal) {
    fault(error.what());
  } else {
    std::string_view const code = code_text(code_of(error.kind()));
    std::string message = error.what();
    if (!code.empty()) message.insert(std::min(message.find('\n'), message.size()), fmt::format(" [{}]", code));
    this->error(message);
  }
}

void Console::fault(std::string_view what) const { labelled("error:", red, fault_report(what, command_line_)); }

void write_standard_output(std::string_view bytes) {
  while (!bytes.empty()) {
    ssize_t const written = ::write(STDOUT_FILENO, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) {
      std::string const reason = errno == EBADF ? "it is closed" : write_failure(errno);
      throw Error(ErrorKind::io, fmt::format("cannot write to standard output: {}", reason));
    }
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

bool is_standard_output_closed() {
  int const flags = ::fcntl(STDOUT_FILENO, F_GETFL);
  return flags < 0 || (flags & O_ACCMODE) == O_RDONLY;  // see open_standard_streams in app/program.cpp
}

}  // namespace lichtraum::app
