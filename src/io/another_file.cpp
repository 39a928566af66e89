#include "io/another_file.hpp"

#include <fmt/format.h>

#include "io/file_signature.hpp"
#include "io/unread_model.hpp"

namespace lichtraum {

bool is_another_file(std::string_view bytes, std::string_view expected, DiagnosticCode code, Diagnostics& diagnostics) {
  std::string what, hint;
  if (auto const signature = recognise_signature(bytes)) {
    what = fmt::format("{}, not {}", signature->what, expected);
    hint = signature->hint;
  } else if (auto const model = recognise_unread_model({}, bytes)) {
    what = model->what;
    hint = model->hint;
  } else {
    return false;
  }
  diagnostics.begin_line({});  // its lines, if any, tell nothing
  diagnostics.add(Severity::error, code, {}, fmt::format("this is {}", what), hint);
  return true;
}

}  // namespace lichtraum
