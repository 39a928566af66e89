#include "core/parse_number.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>

namespace lichtraum {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool starts_number(std::string_view text) {
  return !text.empty() && (is_digit(text[0]) || (text[0] == '.' && text.size() > 1 && is_digit(text[1])));
}

std::string_view without_sign(std::string_view text) {
  if (!text.empty() && (text[0] == '+' || text[0] == '-')) text.remove_prefix(1);
  return text;
}

std::string_view without_unicode_minus(std::string_view text) {
  for (std::string_view const dash : {"\u2212", "\u2012", "\u2013", "\u2014"}) {
    if (text.substr(0, dash.size()) == dash) return text.substr(dash.size());
  }
  return text;
}

bool equals_ignoring_case(std::string_view text, std::string_view lower) {
  if (text.size() != lower.size()) return false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if ((text[i] | 0x20) != lower[i]) return false;
  }
  return true;
}

bool is_not_finite(std::string_view text) {
  std::string_view const word = without_sign(text);
  for (std::string_view const name : {"nan", "inf", "infinity", "nanf", "inff"}) {
    if (equals_ignoring_case(word, name)) return true;
  }
  return false;
}

NumberProblem explain(std::string_view text) {
  if (is_not_finite(text)) return NumberProblem::not_finite;
  std::string_view const number = without_unicode_minus(text);
  if (number.size() != text.size() && parse_number(number).has_value()) return NumberProblem::unicode_minus;
  std::size_t const comma = text.find(',');
  if (comma != std::string_view::npos && comma + 1 < text.size() && is_digit(text[comma + 1]) &&
      (starts_number(without_sign(text)) || comma == text.size() - without_sign(text).size()) &&
      parse_number(text.substr(comma + 1)).has_value()) {
    return NumberProblem::decimal_comma;
  }
  return NumberProblem::not_a_number;
}

// Up to 15 digits and a power of ten up to 22 are exact in a double, and so their quotient is correctly rounded
// (Clinger 1990, "How to read floating point numbers accurately"). That is nearly every number in a scene file.
constexpr int exact_digits = 15;
constexpr std::array<double, exact_digits + 1> powers_of_ten = {1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                                1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};

// [sign] digits [. digits] with at most 15 digits in all; false for anything else.
bool parse_short_decimal(std::string_view text, double& value) {
  char const* at = text.data();
  char const* const end = at + text.size();
  bool const negative = at != end && *at == '-';
  if (at != end && (*at == '-' || *at == '+')) ++at;
  if (end - at > exact_digits + 1) return false;
  std::uint64_t digits = 0;
  char const* const first = at;
  while (at != end && is_digit(*at)) digits = 10 * digits + static_cast<std::uint64_t>(*at++ - '0');
  auto count = at - first;
  std::ptrdiff_t fraction = 0;
  if (at != end && *at == '.') {
    char const* const point = ++at;
    while (at != end && is_digit(*at)) digits = 10 * digits + static_cast<std::uint64_t>(*at++ - '0');
    fraction = at - point;
    count += fraction;
  }
  if (at != end || count == 0 || count > exact_digits) return false;
  double const magnitude = static_cast<double>(digits) / powers_of_ten[static_cast<std::size_t>(fraction)];
  value = negative ? -magnitude : magnitude;
  return true;
}

// from_chars reports too large and too small alike. Too large is what has a positive power of ten: the exponent written
// plus the place of the first digit that counts.
bool is_too_large(std::string_view number) {
  long long place = 0;  // power of ten of the first non-zero digit
  bool seen = false;
  bool after_point = false;
  std::size_t i = 0;
  for (; i < number.size() && (is_digit(number[i]) || number[i] == '.'); ++i) {
    if (number[i] == '.') {
      after_point = true;
    } else if (!seen) {
      seen = number[i] != '0';
      if (after_point) --place;
    } else if (!after_point) {
      ++place;
    }
  }
  if (!seen) return false;
  if (i == number.size()) return place > 0;
  std::string_view exponent = number.substr(i + 1);
  bool const negative = !exponent.empty() && exponent[0] == '-';
  exponent = without_sign(exponent);
  long long written = 0;
  for (char const c : exponent) {
    if (!is_digit(c) || written > std::numeric_limits<int>::max()) break;
    written = 10 * written + (c - '0');
  }
  return place + (negative ? -written : written) > 0;
}

}  // namespace

ParsedNumber parse_number(std::string_view text) {
  ParsedNumber result;
  if (parse_short_decimal(text, result.value)) return result;

  std::string_view const number = without_sign(text);
  if (!starts_number(number)) return {0, explain(text)};
  char const* const end = number.data() + number.size();
  auto const [stop, error] = std::from_chars(number.data(), end, result.value);
  bool const has_f = end - stop == 1 && *stop == 'f';
  if (stop != end && !has_f) return {0, explain(text)};
  if (error == std::errc::result_out_of_range) {
    if (is_too_large(number)) return {0, NumberProblem::too_large};
    result.value = 0;
  } else if (error != std::errc{}) {
    return {0, explain(text)};
  }
  if (result.value > static_cast<double>(std::numeric_limits<float>::max())) return {0, NumberProblem::too_large};
  if (text[0] == '-') result.value = -result.value;
  if (has_f) result.problem = NumberProblem::trailing_f;
  return result;
}

bool looks_like_number(std::string_view text) {
  return starts_number(without_sign(without_unicode_minus(text))) || is_not_finite(text);
}

}  // namespace lichtraum
