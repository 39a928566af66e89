#include "io/esdf/arguments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "core/largest_radiance.hpp"
#include "core/parse_number.hpp"
#include "io/esdf/interpreter.hpp"
#include "io/text/diagnostics.hpp"

namespace lichtraum::esdf {
namespace {

std::size_t sum_of(std::initializer_list<Parameter> const& numbers) {
  std::size_t sum = 0;
  for (Parameter const& parameter : numbers) sum += parameter.count;
  return sum;
}

/// "is m missing?", "are Ks and m missing?", "is a part of Kd missing?"
std::string what_is_missing(Signature const& signature, std::size_t found, bool has_material) {
  std::vector<std::string> missing;
  std::size_t begin = 0;
  for (Parameter const& parameter : signature.numbers) {
    std::size_t const end = begin + parameter.count;
    if (found <= begin) missing.emplace_back(parameter.name);
    if (found > begin && found < end) missing.push_back(fmt::format("a part of {}", parameter.name));
    begin = end;
  }
  if (signature.takes_material && !has_material) missing.emplace_back("the material");
  if (missing.empty()) return "";
  return fmt::format("{} {} missing?", missing.size() == 1 ? "is" : "are", listed(missing, "and"));
}

bool is_number(Token token) { return parse_number(token).has_value(); }

std::string hint_for_no_number(Token token) {
  for (std::string_view const word : {"define", "transform", "render", "camera", "ambient"}) {
    bool const ends_with_word = token.size() > word.size() && token.substr(token.size() - word.size()) == word;
    if (ends_with_word && is_number(token.substr(0, token.size() - word.size()))) {
      return fmt::format("is a line break missing before '{}'?", word);
    }
  }
  if (token.find('=') != Token::npos)
    return "key=value arguments come last, and only materials, lights, cameras and render take them";
  return token.find(',') == Token::npos ? "" : "separate numbers by spaces only";
}

// A key=value argument where none belongs.
bool report_unknown_key(Interpreter& interpreter, Statement const& statement, std::span<Token const> tokens) {
  for (Token const token : tokens) {
    std::size_t const equals = token.find('=');
    if (equals == Token::npos || equals == 0) continue;
    interpreter.error(Code::unknown_key, token,
                      fmt::format("{}: unknown key {}", statement.what, in_quotes(token.substr(0, equals))),
                      fmt::format("{} takes no key=value arguments", with_article(statement.what)));
    return true;
  }
  return false;
}

}  // namespace

std::string listed(std::vector<std::string> const& items, std::string_view last_word) {
  std::string result;
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (i > 0) result += i + 1 == items.size() ? fmt::format(" {} ", last_word) : ", ";
    result += items[i];
  }
  return result;
}

std::string with_article(std::string_view what) {
  bool const has_vowel = std::string_view("aeiou").find(what.front()) != std::string_view::npos;
  return fmt::format("{} {}", has_vowel ? "an" : "a", what);
}

void report_wrong_count(Interpreter& interpreter, Statement const& statement, Signature const& signature) {
  std::size_t const expected = sum_of(signature.numbers);
  std::vector<std::string> counts{std::to_string(expected)};
  if (!interpreter.options.strict) {
    for (std::size_t const count : signature.other_counts) counts.push_back(std::to_string(count));
  }
  std::string const wanted =
      fmt::format("{} number{}{}", listed(counts, "or"), expected == 1 && counts.size() == 1 ? "" : "s",
                  signature.takes_material ? " and a material" : "");
  if (statement.arguments.empty()) {
    interpreter.error(Code::wrong_count, place_after(statement.keyword),
                      fmt::format("{}: expected a name{} {}, found nothing", statement.what,
                                  signature.takes_material ? "," : " and", wanted),
                      std::string(signature.usage));
    return;
  }

  std::span<Token const> const tokens = statement.arguments.subspan(1);
  auto const first_word = std::find_if_not(tokens.begin(), tokens.end(), looks_like_number);
  auto const numbers = static_cast<std::size_t>(first_word - tokens.begin());
  std::size_t const words = tokens.size() - numbers;
  if (report_unknown_key(interpreter, statement, tokens.subspan(numbers))) return;
  // An argument that is not a number explains a wrong count better than the count does.
  auto const faulty = std::find_if_not(tokens.begin(), first_word, is_number);
  if (faulty != first_word) {
    read_number(interpreter, *faulty);
    return;
  }

  // 'found 5', 'found 5 and a material', 'found 5 and 3 more words'
  std::string found = std::to_string(numbers);
  if (words == 1 && signature.takes_material) {
    found += " and a material";
  } else if (words == 1) {
    found += fmt::format(" and {}", in_quotes(*first_word));
  } else if (words > 1) {
    found += fmt::format(" and {} more words", words);
  }

  std::string missing;
  Token at;
  bool const lacks_number = numbers < expected;
  if (lacks_number && numbers + 1 == expected && looks_like_number(statement[0])) {
    missing = "is the name missing?";
    at = statement[0];
  } else if (lacks_number || (signature.takes_material && words == 0 && numbers == expected)) {
    if (words < 2) missing = what_is_missing(signature, numbers, words > 0);  // else a word is wrong, not the count
    at = words > 0 ? *first_word : place_after(statement.last());
  } else {
    std::size_t good = expected;
    for (std::size_t const count : signature.other_counts) {
      if (count <= numbers && !interpreter.options.strict) good = std::max(good, count);
    }
    if (numbers == expected && signature.takes_material) ++good;
    at = statement.rest(1 + std::min(good, tokens.size() - 1));
  }
  std::string hint(signature.usage);
  bool const has_comment = std::any_of(first_word, tokens.end(), is_comment);
  if (has_comment) hint = comment_hint;
  if (statement[0].front() == '"') {
    at = statement[0];
    hint = "names have neither quotes nor spaces";
  }
  interpreter.error(Code::wrong_count, at,
                    fmt::format("{}: expected {}, found {}{}", statement.what, wanted, found,
                                missing.empty() ? "" : fmt::format(" ({})", missing)),
                    std::move(hint));
}

std::optional<double> read_number(Interpreter& interpreter, Token token) {
  ParsedNumber const number = parse_number(token);
  switch (number.problem) {
    case NumberProblem::none:
      break;
    case NumberProblem::trailing_f:
      interpreter.warning(Code::number_with_f, token,
                          fmt::format("{}: the f after the number is not part of it", in_quotes(token)),
                          "leave it out");
      break;
    case NumberProblem::not_a_number:
      interpreter.error(Code::not_a_number, token, fmt::format("{} is not a number", in_quotes(token)),
                        hint_for_no_number(token));
      return std::nullopt;
    case NumberProblem::decimal_comma: {
      std::string with_point(token);
      std::replace(with_point.begin(), with_point.end(), ',', '.');
      interpreter.error(Code::not_a_number, token, fmt::format("{} is not a number", in_quotes(token)),
                        fmt::format("decimals have a point: {}", in_quotes(with_point)));
      return std::nullopt;
    }
    case NumberProblem::unicode_minus:
      interpreter.error(Code::not_a_number, token, fmt::format("{} is not a number", in_quotes(token)),
                        "this is a typographic dash: write the ASCII minus '-'");
      return std::nullopt;
    case NumberProblem::not_finite:
      interpreter.error(Code::not_a_number, token, fmt::format("{} is not a finite number", in_quotes(token)));
      return std::nullopt;
    case NumberProblem::too_large:
      interpreter.error(Code::number_too_large, token, fmt::format("{} is too large", in_quotes(token)),
                        "single-precision numbers reach about 3.4e38");
      return std::nullopt;
  }
  return number.value;
}

bool read_numbers(Interpreter& interpreter, std::span<Token const> tokens, std::span<double> values) {
  bool good = true;
  bool has_comma = false;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    // Where one number has a comma after it, all of them have: that is one mistake.
    if (tokens[i].back() == ',' && is_number(tokens[i].substr(0, tokens[i].size() - 1)) &&
        std::exchange(has_comma, true)) {
      continue;
    }
    if (auto const value = read_number(interpreter, tokens[i])) {
      values[i] = *value;
    } else {
      good = false;
    }
  }
  return good;
}

std::optional<Vec3> read_vec3(Interpreter& interpreter, std::span<Token const> three_tokens) {
  std::array<double, 3> v{};
  if (!read_numbers(interpreter, three_tokens.first(3), v)) return std::nullopt;
  return Vec3(v[0], v[1], v[2]);
}

std::optional<Rgb> read_radiance(Interpreter& interpreter, std::span<Token const> three_tokens, std::string_view what) {
  auto const radiance = read_vec3(interpreter, three_tokens);
  if (!radiance) return std::nullopt;
  for (int c = 0; c < 3; ++c) {
    if ((*radiance)[c] >= 0 && (*radiance)[c] <= largest_radiance) continue;
    interpreter.error(Code::out_of_range, three_tokens[std::size_t(c)],
                      fmt::format("{} must lie between 0 and {:g}, not {}", what, largest_radiance,
                                  in_quotes(three_tokens[std::size_t(c)])));
    return std::nullopt;
  }
  return radiance;
}

std::optional<int> read_whole_number(Interpreter& interpreter, Token token, std::string_view what, int smallest) {
  auto const value = read_number(interpreter, token);
  if (!value) return std::nullopt;
  constexpr int largest = std::numeric_limits<int>::max();
  if (*value != std::floor(*value) || *value < smallest || *value > largest) {
    interpreter.error(
        Code::not_a_whole_number, token,
        fmt::format("{} must be a whole number from {} to {}, not {}", what, smallest, largest, in_quotes(token)));
    return std::nullopt;
  }
  return static_cast<int>(*value);
}

std::optional<Resolution> read_resolution(Interpreter& interpreter, Token width, Token height) {
  auto const w = read_whole_number(interpreter, width, "the width", 1);
  auto const h = read_whole_number(interpreter, height, "the height", 1);
  if (!w || !h) return std::nullopt;
  return Resolution{*w, *h};
}

}  // namespace lichtraum::esdf
