#pragma once

#include "lichtraum/error.hpp"

namespace lichtraum::app {

/// What kind of diagnostic a failure is that has no place in a scene. None of a refused command line, whose message and
/// --help say all, of an interruption, and of a fault of lichtraum's own.
constexpr DiagnosticCode code_of(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::scene:
      return DiagnosticCode::undrawable_scene;
    case ErrorKind::no_input:
      return DiagnosticCode::missing_input;
    case ErrorKind::no_device:
      return DiagnosticCode::unusable_device;
    case ErrorKind::cannot_create:
      return DiagnosticCode::unwritable_output;
    case ErrorKind::io:
      return DiagnosticCode::failed_transfer;
    case ErrorKind::try_again:
      return DiagnosticCode::try_again;
    case ErrorKind::usage:
    case ErrorKind::unavailable:
    case ErrorKind::internal:
    case ErrorKind::interrupted:
      return DiagnosticCode::none;
  }
  return DiagnosticCode::none;
}

}  // namespace lichtraum::app
