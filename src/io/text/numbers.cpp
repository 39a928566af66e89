#include "io/text/numbers.hpp"

#include <fmt/format.h>

#include <limits>

#include "core/parse_number.hpp"

namespace lichtraum {
namespace {

bool take_or_warn(ParsedNumber const& number, Token word, double& value, Diagnostics& diagnostics) {
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

}  // namespace

bool read_number(Token word, double& value, Diagnostics& diagnostics) {
  return take_or_warn(parse_number(word), word, value, diagnostics);
}

bool read_number_or_nan(Token word, double& value, Diagnostics& diagnostics) {
  ParsedNumber number = parse_number(word);
  if (number.problem == NumberProblem::not_finite)
    number = {std::numeric_limits<double>::quiet_NaN(), NumberProblem::none};
  return take_or_warn(number, word, value, diagnostics);
}

}  // namespace lichtraum
