#include "core/parse_number.hpp"

#include <clocale>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>

#include "support/catch.hpp"

using namespace lichtraum;

namespace {

NumberProblem problem(std::string_view text) { return parse_number(text).problem; }

}  // namespace

TEST_CASE("numbers in every accepted form", "[unit][number]") {
  struct Case {
    char const* text;
    double value;
  };
  for (Case const& c : {Case{"0", 0},
                        {"5", 5},
                        {"-5", -5},
                        {"+1", 1},
                        {".5", 0.5},
                        {"5.", 5},
                        {"-.5", -0.5},
                        {"1e-3", 1e-3},
                        {"1E3", 1e3},
                        {"+1.5e+2", 150},
                        {"007", 7},
                        {"0.1", 0.1},
                        {"123456789012345", 123456789012345.0},
                        {"0.000001", 1e-6},
                        {"1e-400", 0},
                        {"-1e-400", 0},
                        {"3.4028234e38", 3.4028234e38},
                        {"0.0000000000000000000000000000000001", 1e-34},
                        {"12345678901234567890123", 12345678901234567890123.0},
                        {"0e999999999999", 0},
                        {"0.0000000000000000000000000000000000000000001e43", 1}}) {
    INFO(c.text);
    ParsedNumber const parsed = parse_number(c.text);
    CHECK(parsed.problem == NumberProblem::none);
    CHECK(parsed.value == c.value);
    CHECK(looks_like_number(c.text));
  }
  CHECK(std::signbit(parse_number("-0").value));
  CHECK_FALSE(std::signbit(parse_number("0").value));
}

TEST_CASE("numbers that are none, and why", "[unit][number]") {
  for (char const* text : {"",    "-",  "+",  ".",  "-.", "e5", "abc", "1.2.3", "0x10",  "1e", "1e+", "--1", "+-1",
                           "-+1", "1 ", " 1", "1-", "f",  "ff", "1ff", "1_000", "1,2,3", ",",  "1,",  "x,5"}) {
    INFO(text);
    CHECK(problem(text) == NumberProblem::not_a_number);
  }
  for (char const* text : {"1,5", "-1,5", ",5", "-,5", "0,25e1"}) {
    INFO(text);
    CHECK(problem(text) == NumberProblem::decimal_comma);
  }
  for (char const* text : {"nan", "NaN", "-nan", "inf", "Inf", "-INF", "+infinity"}) {
    INFO(text);
    CHECK(problem(text) == NumberProblem::not_finite);
  }
  for (char const* text : {"1e39", "-1e39", "3.5e38", "1e400", "1e99999999999999999999", "-1e400f",
                           "999999999999999999999999999999999999999999", "0.001e500"}) {
    INFO(text);
    CHECK(problem(text) == NumberProblem::too_large);
  }
  for (char const* text : {"\u22121", "\u20131.5", "\u2014.5"}) {
    INFO(text);
    CHECK(problem(text) == NumberProblem::unicode_minus);
  }
  CHECK(problem("\u2212") == NumberProblem::not_a_number);
}

TEST_CASE("a trailing f is kept apart from the number", "[unit][number]") {
  for (char const* text : {"1f", "1.0f", ".5f", "1e-3f", "-2.5f"}) {
    INFO(text);
    CHECK(problem(text) == NumberProblem::trailing_f);
    CHECK(parse_number(text).value == std::strtod(text, nullptr));
  }
}

TEST_CASE("numbers do not depend on the locale", "[unit][number]") {
  char const* const before = std::setlocale(LC_ALL, nullptr);
  std::string const restore = before ? before : "C";
  // Where none of these is installed this checks the C locale again.
  for (char const* name : {"de_DE.UTF-8", "de_DE", "fr_FR.UTF-8"}) {
    if (std::setlocale(LC_ALL, name)) break;
  }
  CHECK(parse_number("1.5").value == 1.5);
  CHECK(parse_number("0.1234567890123456789").value == 0.1234567890123456789);
  CHECK(problem("1,5") == NumberProblem::decimal_comma);
  std::setlocale(LC_ALL, restore.c_str());
}

// The short way through parse_number against strtod, which is correctly rounded in glibc.
TEST_CASE("numbers are rounded correctly", "[unit][number]") {
  std::mt19937_64 random(7);
  for (int i = 0; i < 200'000; ++i) {
    int const digits = 1 + static_cast<int>(random() % 18);
    std::string text;
    for (int d = 0; d < digits; ++d) text += static_cast<char>('0' + random() % 10);
    text.insert(random() % (text.size() + 1), ".");
    if (random() % 4 == 0) text += "e" + std::to_string(static_cast<int>(random() % 60) - 40);
    if (random() % 2 == 0) text.insert(0, "-");
    double const expected = std::strtod(text.c_str(), nullptr);
    ParsedNumber const parsed = parse_number(text);
    if (std::abs(expected) > static_cast<double>(std::numeric_limits<float>::max())) {
      if (parsed.problem != NumberProblem::too_large) FAIL(text);
    } else if (parsed.problem != NumberProblem::none || parsed.value != expected) {
      FAIL(text);
    }
  }
}
