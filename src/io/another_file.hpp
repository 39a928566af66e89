#pragma once

#include <optional>
#include <string>

#include "io/text/diagnostics.hpp"

namespace lichtraum {

/// What a file certainly is that is not what it should be.
struct AnotherFile {
  std::string message;  ///< "this is an HTML document, not an OBJ model"
  std::string hint;     ///< may be empty
};

/// For bytes that do not begin as a format's files do. `expected` is "an OBJ model".
std::optional<AnotherFile> recognise_another_file(std::string_view bytes, std::string_view expected);

/// The same, as an error; true when there is one.
bool is_another_file(std::string_view bytes, std::string_view expected, DiagnosticCode code, Diagnostics& diagnostics);

}  // namespace lichtraum
