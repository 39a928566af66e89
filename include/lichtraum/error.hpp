#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "lichtraum/api.hpp"
#include "lichtraum/diagnostic_code.hpp"

namespace LICHTRAUM_API lichtraum {

/// What went wrong, as far as a caller has to tell cases apart. The program maps each to an exit code (sysexits.h).
enum class ErrorKind {
  usage,          ///< the request itself is invalid (64)
  scene,          ///< a scene or model is faulty (65)
  no_input,       ///< an input cannot be opened (66)
  no_device,      ///< no such device, or it cannot be used (69)
  unavailable,    ///< another program or a display is needed and not there (69)
  internal,       ///< a fault in lichtraum (70)
  cannot_create,  ///< an output cannot be created (73)
  io,             ///< reading or writing failed half-way (74)
  try_again,      ///< what may succeed later: a disk is full, parts are missing (75)
  interrupted,    ///< stopped by the user (130)
};

/// A place in a text file. Lines and columns count from 1, columns in bytes; 0 means "the whole file" or "the line".
struct SourceLocation {
  std::string file;
  std::size_t line = 0;
  std::size_t column = 0;
};

enum class Severity { note, warning, error };
/// "note", "warning" or "error".
std::string_view severity_text(Severity severity);

/// One finding in an input, ready to be shown.
struct Diagnostic {
  Severity severity = Severity::error;
  DiagnosticCode code = DiagnosticCode::none;  ///< its kind
  SourceLocation location;
  std::size_t length = 1;   ///< width of the marked token in bytes
  std::string message;      ///< what and why
  std::string source_line;  ///< the line as written, without its line break; may be empty
  std::string hint;         ///< what to do; may be empty
};

/// `file:line:column: error: message [E0412]`, without a code where there is none, the source line, a caret line and
/// the hint. Ends with a newline.
std::string format_diagnostic(Diagnostic const& diagnostic);

/// What is wrong with input, a request, a device or a file. Values that no object can have are a std::invalid_argument.
class Error : public std::runtime_error {
 public:
  Error(ErrorKind kind, std::string const& message) : std::runtime_error(message), kind_(kind) {}
  ErrorKind kind() const { return kind_; }

 private:
  ErrorKind kind_;
};

/// A faulty scene or model: carries every diagnostic, warnings included. what() is the formatted list.
class SceneError : public Error {
 public:
  explicit SceneError(std::vector<Diagnostic> diagnostics);
  std::vector<Diagnostic> const& diagnostics() const { return diagnostics_; }

 private:
  std::vector<Diagnostic> diagnostics_;
};

/// A failed OpenCL call or an unusable device. `call` is the call's name, `code` what it returned.
class DeviceError : public Error {
 public:
  DeviceError(std::string const& message, std::string call, int code)
      : Error(ErrorKind::no_device, message), call_(std::move(call)), code_(code) {}
  std::string const& call() const { return call_; }
  int code() const { return code_; }

 private:
  std::string call_;
  int code_;
};

}  // namespace lichtraum
