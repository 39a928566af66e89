#pragma once

#include <array>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/esdf/lexer.hpp"
#include "io/text/diagnostics.hpp"
#include "lichtraum/camera.hpp"
#include "lichtraum/math.hpp"

namespace lichtraum::esdf {

class Interpreter;

/// How other languages begin a comment.
inline bool is_comment(Token token) { return token.substr(0, 2) == "//"; }
inline constexpr std::string_view comment_hint = "a comment after a statement starts with '#'";

/// A statement: what it is called in messages, and its tokens after that word.
struct Statement {
  std::string_view what;  ///< "sphere", "render"
  Token keyword;          ///< the token that says so
  std::span<Token const> arguments;

  std::size_t size() const { return arguments.size(); }
  Token operator[](std::size_t i) const { return arguments[i]; }
  Token last() const { return arguments.empty() ? keyword : arguments.back(); }
  /// From argument `first` to the end.
  Token rest(std::size_t first) const { return span_of(arguments[first], last()); }
};

/// A group of numbers that a statement takes: {"center", 3}.
struct Parameter {
  std::string_view name;
  std::size_t count;
};

/// What a statement takes after its name.
struct Signature {
  std::initializer_list<Parameter> numbers;
  bool takes_material = false;
  std::initializer_list<std::size_t> other_counts = {};  ///< numbers that dialects take as well
  std::string_view usage = {};                           ///< a hint where the count alone says little
};

/// "a, b and c", where `last_word` is "and".
std::string listed(std::vector<std::string> const& items, std::string_view last_word);

/// "a material", "an ambient light".
std::string with_article(std::string_view what);

/// Reports that `statement` (name, numbers, and a material where there is one) lacks what `signature` takes.
void report_wrong_count(Interpreter& interpreter, Statement const& statement, Signature const& signature);

/// The tokens' values. Every faulty one is reported; then false.
bool read_numbers(Interpreter& interpreter, std::span<Token const> tokens, std::span<double> values);

std::optional<double> read_number(Interpreter& interpreter, Token token);
std::optional<Vec3> read_vec3(Interpreter& interpreter, std::span<Token const> three_tokens);
/// Light that is sent out, 0 to 1e30 each: sums of many samples stay numbers. `what` starts the message.
std::optional<Rgb> read_radiance(Interpreter& interpreter, std::span<Token const> three_tokens, std::string_view what);

/// A whole number, at least `smallest`; `what` starts the message: "the width".
std::optional<int> read_whole_number(Interpreter& interpreter, Token token, std::string_view what, int smallest);
std::optional<Resolution> read_resolution(Interpreter& interpreter, Token width, Token height);

}  // namespace lichtraum::esdf
