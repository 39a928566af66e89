#pragma once

#include <string_view>

namespace lichtraum {

enum class NumberProblem {
  none,
  trailing_f,     ///< `1.0f`: the value is there, but the f does not belong
  not_a_number,   ///< `abc`, `1.2.3`, `0x10`, an empty text
  decimal_comma,  ///< `1,5`
  unicode_minus,  ///< a minus sign or dash of word processors (U+2212, U+2012..2014) before a number
  not_finite,     ///< `nan`, `inf`
  too_large,      ///< beyond the range of a float: pictures are computed in single precision
};

struct ParsedNumber {
  double value = 0;
  NumberProblem problem = NumberProblem::none;
  bool has_value() const { return problem == NumberProblem::none || problem == NumberProblem::trailing_f; }
};

/// A decimal floating point number, the whole of `text`, whatever the process locale: `5`, `.5`, `5.`, `+1`, `-0`,
/// `1e-3`. What is too small for a double is 0.
ParsedNumber parse_number(std::string_view text);

/// Whether `text` is a number or is meant as one: starts like a number (`1,5`, `3x`) or is one that is not accepted.
bool looks_like_number(std::string_view text);

}  // namespace lichtraum
