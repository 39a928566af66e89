#pragma once

#include "io/text/diagnostics.hpp"

namespace lichtraum {

/// For bytes that do not begin as a format's files do: adds an error when they are certainly something else, and is
/// true then. `expected` is "an OBJ model".
bool is_another_file(std::string_view bytes, std::string_view expected, DiagnosticCode code, Diagnostics& diagnostics);

}  // namespace lichtraum
