#include "io/text/numbers.hpp"

#include <fmt/format.h>

#include "core/parse_number.hpp"

namespace lichtraum {

bool read_number(Token word, double& value, Diagnostics& diagnostics) {
  ParsedNumber const number = parse_number(word);
  if (number.problem == NumberProblem::none) {
    value = number.value;
    return true;
  }
  char const* what = "is not a number";
  if (number.problem == NumberProblem::not_finite) what = "is not a finite number";
  if (number.problem == NumberProblem::too_large) what = "is too large";
  if (number.problem == NumberProblem::decimal_comma) what = "is not a number: the decimal separator is a point";
  diagnostics.add(Severity::warning, DiagnosticCode::faulty_number, word, fmt::format("{} {}", in_quotes(word), what));
  return false;
}

}  // namespace lichtraum
