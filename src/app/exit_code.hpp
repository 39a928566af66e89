#pragma once

#include "lichtraum/error.hpp"

namespace lichtraum::app {

/// What the process returns, after sysexits.h where that has a number.
constexpr int exit_code(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::usage:
      return 64;
    case ErrorKind::scene:
      return 65;
    case ErrorKind::no_input:
      return 66;
    case ErrorKind::no_device:
    case ErrorKind::unavailable:
      return 69;
    case ErrorKind::internal:
      return 70;
    case ErrorKind::cannot_create:
      return 73;
    case ErrorKind::io:
      return 74;
    case ErrorKind::try_again:
      return 75;
    case ErrorKind::interrupted:
      return 130;
  }
  return 70;
}

}  // namespace lichtraum::app
