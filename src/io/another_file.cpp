#include "io/another_file.hpp"

#include <fmt/format.h>

#include "io/file_signature.hpp"

namespace lichtraum {

bool is_another_file(std::string_view bytes, std::string_view expected, DiagnosticCode code, Diagnostics& diagnostics) {
  auto const signature = recognise_signature(bytes);
  if (!signature) return false;
  diagnostics.begin_line({});  // its lines, if any, tell nothing
  diagnostics.add(Severity::error, code, {}, fmt::format("this is {}, not {}", signature->what, expected),
                  std::string(signature->hint));
  return true;
}

}  // namespace lichtraum
