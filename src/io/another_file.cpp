#include "io/another_file.hpp"

#include <fmt/format.h>

#include "io/file_signature.hpp"
#include "io/unread_model.hpp"

namespace lichtraum {

std::optional<AnotherFile> recognise_another_file(std::string_view bytes, std::string_view expected) {
  if (auto const signature = recognise_signature(bytes)) {
    return AnotherFile{fmt::format("this is {}, not {}", signature->what, expected), std::string(signature->hint)};
  }
  if (auto const model = recognise_unread_model({}, bytes)) return AnotherFile{"this is " + model->what, model->hint};
  return std::nullopt;
}

bool is_another_file(std::string_view bytes, std::string_view expected, DiagnosticCode code, Diagnostics& diagnostics) {
  auto const other = recognise_another_file(bytes, expected);
  if (!other) return false;
  diagnostics.begin_line({});  // its lines, if any, tell nothing
  diagnostics.add(Severity::error, code, {}, other->message, other->hint);
  return true;
}

}  // namespace lichtraum
