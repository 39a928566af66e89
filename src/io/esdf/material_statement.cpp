#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "core/parse_number.hpp"
#include "io/esdf/color_range.hpp"
#include "io/esdf/interpreter.hpp"
#include "io/esdf/keys.hpp"
#include "io/esdf/statements.hpp"

// define material <name> [Ka] [Kd] [Ks] <m> [reflect=<0..1>] [transmit=<0..1>] [ior=<n>] [emission [rgb]]
// Dialects: one to four more numbers, whose meaning options.material_extras says.

namespace lichtraum::esdf {
namespace {

Signature const material_signature{{{"Ka", 3}, {"Kd", 3}, {"Ks", 3}, {"m", 1}}};
constexpr std::size_t least_numbers = 10;
constexpr std::size_t most_numbers = 14;

#define LICHTRAUM_NONE(...)

/// The terms that have keys, or words of their own, as far as they were given.
struct OptionalTerms {
#define LICHTRAUM_COLOR(name, ...) std::optional<Rgb> name;
#define LICHTRAUM_TERM(name, ...) std::optional<double> name;
  PHONG_OPTIONAL_FIELDS(LICHTRAUM_COLOR, LICHTRAUM_TERM, LICHTRAUM_TERM)
#undef LICHTRAUM_COLOR
#undef LICHTRAUM_TERM
};

/// A term that is a word and three numbers.
struct ColorWord {
  std::string_view word;
  std::optional<Rgb> OptionalTerms::*term;
};
constexpr ColorWord color_words[] = {
#define LICHTRAUM_COLOR(name, initial) {#name, &OptionalTerms::name},
    PHONG_OPTIONAL_FIELDS(LICHTRAUM_COLOR, LICHTRAUM_NONE, LICHTRAUM_NONE)
#undef LICHTRAUM_COLOR
};

ColorWord const* find_color_word(Token token) {
  auto const* const found = std::find_if(std::begin(color_words), std::end(color_words),
                                         [&](ColorWord const& known) { return known.word == token; });
  return found == std::end(color_words) ? nullptr : found;
}

/// "emission <r> <g> <b>"
std::string usage_of(ColorWord const& color) { return fmt::format("{} <r> <g> <b>", color.word); }

/// A term in its range.
std::optional<double> read_share(Interpreter& interpreter, std::string_view word, Token value) {
  auto const share = read_number(interpreter, value);
  if (!share || (*share >= 0 && *share <= 1)) return share;
  interpreter.error(Code::out_of_range, value,
                    fmt::format("material: {} must lie between 0 and 1, not {}", word, in_quotes(value)));
  return std::nullopt;
}
std::optional<double> read_positive(Interpreter& interpreter, std::string_view word, Token value) {
  auto const number = read_number(interpreter, value);
  if (!number || *number > 0) return number;
  interpreter.error(Code::out_of_range, value,
                    fmt::format("material: {} must be greater than 0, not {}", word, in_quotes(value)),
                    word == "ior" ? "air is 1, water 1.33, glass 1.5" : "");
  return std::nullopt;
}

/// What fills `terms`.
auto keys_of(Interpreter& interpreter, OptionalTerms& terms) {
  using Read = std::optional<double> (*)(Interpreter&, std::string_view, Token);
  auto const key = [&interpreter](std::string_view word, std::optional<double>& term, Read read) {
    return Key{word, [&interpreter, &term, word, read](Token value) {
                 term = read(interpreter, word, value);
                 return term.has_value();
               }};
  };
  return std::to_array<Key>({
#define LICHTRAUM_SHARE(name, initial) key(#name, terms.name, read_share),
#define LICHTRAUM_NUMBER(name, initial, least, most) key(#name, terms.name, read_positive),
      PHONG_OPTIONAL_FIELDS(LICHTRAUM_NONE, LICHTRAUM_SHARE, LICHTRAUM_NUMBER)
#undef LICHTRAUM_SHARE
#undef LICHTRAUM_NUMBER
  });
}

/// `tokens` start with the word.
bool read_color(Interpreter& interpreter, ColorWord const& color, std::span<Token const> tokens, OptionalTerms& terms) {
  if (tokens.size() < 4) {
    interpreter.error(Code::wrong_count, place_after(tokens.back()),
                      fmt::format("material: {} is followed by 3 numbers", color.word), usage_of(color));
    return false;
  }
  Token const at = span_of(tokens[0], tokens[3]);
  if (!interpreter.dialect(at, color.word)) return false;
  if (terms.*color.term) {
    interpreter.error(Code::given_twice, at, fmt::format("material: {} is given twice", color.word));
    return false;
  }
  terms.*color.term = read_radiance(interpreter, tokens.subspan(1, 3), fmt::format("material: {}", color.word));
  return (terms.*color.term).has_value();
}

/// The term that was probably meant by a word that is none, as it is written with the numbers after it:
/// "write reflect=0.3". Else an empty text.
std::string correct_term(Interpreter& interpreter, Token word, std::span<Token const> numbers,
                         std::span<Key const> keys) {
  std::vector<std::string_view> known;
  for (Key const& key : keys) known.push_back(key.word);
  for (ColorWord const& color : color_words) known.push_back(color.word);
  std::string_view const nearest = interpreter.nearest(word, known);
  if (nearest.empty()) return {};
  if (ColorWord const* const color = find_color_word(nearest)) {
    if (numbers.size() != 3) return usage_of(*color);
    return fmt::format("write {} {}", color->word, span_of(numbers.front(), numbers.back()));
  }
  return fmt::format("write {}={}", nearest, numbers.size() == 1 ? numbers[0] : "<number>");
}

/// Reports a word that is no term, and what was probably meant by it: `tokens` are it and the numbers after it.
void report_unknown_term(Interpreter& interpreter, std::span<Token const> tokens, std::span<Key const> keys) {
  Token const whole = tokens.front();
  std::size_t const colon = std::min(whole.find(':'), whole.size());
  Token const word = whole.substr(0, colon);
  std::vector<Token> numbers(tokens.begin() + 1, tokens.end());
  if (colon + 1 < whole.size()) numbers.insert(numbers.begin(), whole.substr(colon + 1));
  std::string hint = correct_term(interpreter, word, numbers, keys);
  if (hint.empty()) hint = "numbers come before " + list_of(keys, usage_of(color_words[0]));
  interpreter.error(Code::expected_key, span_of(whole, tokens.back()),
                    fmt::format("material: expected key=value, found {}", in_quotes(whole)), std::move(hint));
}

/// What follows the numbers: colours and keys, in any order.
bool read_terms(Interpreter& interpreter, Statement const& statement, std::size_t first, OptionalTerms& terms) {
  std::vector<Token> others;
  auto const keys = keys_of(interpreter, terms);
  bool good = true;
  for (std::size_t i = first; i < statement.size(); ++i) {
    Token const token = statement[i];
    Token const word = token.substr(0, token.find('='));
    ColorWord const* const color = find_color_word(word);
    std::span<Token const> const rest = statement.arguments.subspan(i);
    if (is_comment(token)) {
      interpreter.error(Code::expected_key, statement.rest(i),
                        fmt::format("material: expected key=value, found {}", in_quotes(token)),
                        std::string(comment_hint));
      good = false;
      break;
    }
    if (!color && !has_key(token) && !looks_like_number(token)) {
      auto const end = std::find_if_not(rest.begin() + 1, rest.end(), looks_like_number);
      std::size_t const count = std::size_t(end - rest.begin());
      report_unknown_term(interpreter, rest.first(count), keys);
      good = false;
      i += count - 1;
    } else if (!color) {
      others.push_back(token);
    } else if (word != token) {
      interpreter.error(Code::color_with_equals, token,
                        fmt::format("material: {} is followed by 3 numbers, not by '='", word), usage_of(*color));
      good = false;
    } else {
      auto const next_key = std::find_if(rest.begin(), rest.end(), has_key);
      std::size_t const count = std::min<std::size_t>(4, std::size_t(next_key - rest.begin()));
      good &= read_color(interpreter, *color, rest.first(count), terms);
      i += count - 1;
    }
  }
  std::string const color_usage = usage_of(color_words[0]);
  return read_keys(interpreter, {statement.what, statement.keyword, others}, 0, keys,
                   "numbers come before " + list_of(keys, color_usage), color_usage) &&
         good;
}

// Extra numbers have no fixed meaning and come from programs with other ranges: they are brought into range.
void apply_extra(MaterialExtra meaning, double value, OptionalTerms& terms) {
  double const share = std::clamp(value, 0.0, 1.0);
  switch (meaning) {
    case MaterialExtra::reflectance:
      terms.reflect = share;
      break;
    case MaterialExtra::transmittance:
      terms.transmit = share;
      break;
    case MaterialExtra::opacity:
      terms.transmit = 1 - share;
      break;
    case MaterialExtra::ior:
      terms.ior = value > 0 ? value : 1;
      break;
    case MaterialExtra::ignore:
      break;
  }
}

bool read_extras(Interpreter& interpreter, std::span<Token const> tokens, OptionalTerms& terms) {
  auto const& meanings = interpreter.options.material_extras;
  std::array<double, most_numbers - least_numbers> values{};
  if (!read_numbers(interpreter, tokens, values)) return false;
  Token const at = span_of(tokens.front(), tokens.back());
  std::string const count = fmt::format("{} number{} after m", tokens.size(), tokens.size() == 1 ? "" : "s");
  if (meanings.size() < tokens.size()) {
    std::size_t const named = meanings.size();
    bool const accepted = interpreter.dialect_warning(
        Code::extra_material_numbers, span_of(tokens[named], tokens.back()),
        named == 0 ? fmt::format("material: {}{}", count, interpreter.options.strict ? "" : ", ignored")
                   : fmt::format("material: {}, only the first {} named by --material-extras", count, named),
        interpreter.done_unless_strict(
            "--material-extras says what they mean, e.g. --material-extras reflectance,ior"));
    if (!accepted) return false;
  } else if (!interpreter.dialect(at, "a material with " + count)) {
    return false;
  }
  for (std::size_t i = 0; i < std::min(meanings.size(), tokens.size()); ++i) {
    apply_extra(meanings[i], values[i], terms);
  }
  if (!meanings.empty() && terms.reflect.value_or(0) + terms.transmit.value_or(0) > 1) {
    interpreter.warning(
        Code::more_than_all_light_in_extras, at,
        "material: reflectance and transmittance add up to more than 1; reflectance gets what transmittance leaves");
    terms.reflect = 1 - *terms.transmit;
  }
  return true;
}

/// Of ka, kd and ks: one warning for all.
void warn_of_colors(Interpreter& interpreter, std::span<Token const> tokens, std::span<double const> values) {
  std::size_t first = 0;
  for (char const* const name : {"Ka", "Kd", "Ks"}) {
    std::string const what = fmt::format("material: {}", name);
    if (!check_color(interpreter, tokens.subspan(first, 3), values.subspan(first, 3), what, largest_share)) return;
    first += 3;
  }
}

bool read_material(Interpreter& interpreter, Statement const& statement) {
  auto const& arguments = statement.arguments;
  auto const first_key =
      std::find_if(arguments.begin() + (arguments.empty() ? 0 : 1), arguments.end(), [&](Token const& token) {
        bool const is_after_numbers = &token > &arguments[0] + least_numbers;
        return has_key(token) || find_color_word(token) || (is_after_numbers && !looks_like_number(token));
      });
  auto const positional = static_cast<std::size_t>(first_key - arguments.begin());
  if (positional < 1 + least_numbers || positional > 1 + most_numbers) {
    report_wrong_count(interpreter, {statement.what, statement.keyword, arguments.first(positional)},
                       material_signature);
    return false;
  }

  std::array<double, least_numbers> v{};
  OptionalTerms terms;
  bool good = read_numbers(interpreter, arguments.subspan(1, least_numbers), v);
  if (positional > 1 + least_numbers) {
    good &= read_extras(interpreter, arguments.subspan(1 + least_numbers, positional - 1 - least_numbers), terms);
  }
  // A key says it clearly, so it wins over an extra number.
  OptionalTerms named;
  if (first_key != arguments.end()) good &= read_terms(interpreter, statement, positional, named);
  if (good && v[9] < 0) {
    interpreter.error(Code::out_of_range, arguments[least_numbers],
                      fmt::format("material: m must not be negative, not {}", in_quotes(arguments[least_numbers])));
    good = false;
  }
  if (!good) return false;
  warn_of_colors(interpreter, arguments.subspan(1, 9), std::span(v).first(9));

  PhongModel model{.ka = {v[0], v[1], v[2]}, .kd = {v[3], v[4], v[5]}, .ks = {v[6], v[7], v[8]}, .m = v[9]};
#define LICHTRAUM_TERM(name, ...) model.name = named.name.value_or(terms.name.value_or(model.name));
  PHONG_OPTIONAL_FIELDS(LICHTRAUM_TERM, LICHTRAUM_TERM, LICHTRAUM_TERM)
#undef LICHTRAUM_TERM
#undef LICHTRAUM_NONE
  if (model.reflect + model.transmit > 1) {
    interpreter.error(Code::more_than_all_light, span_of(*first_key, arguments.back()),
                      "material: reflect + transmit must not exceed 1");
    return false;
  }
  interpreter.define(arguments[0], std::make_shared<Material>(std::string(arguments[0]), model));
  return true;
}

}  // namespace

void define_material(Interpreter& interpreter, Statement const& statement) {
  if (!read_material(interpreter, statement) && statement.size() > 0) {
    interpreter.mark_faulty(Kind::material, statement[0]);
  }
}

}  // namespace lichtraum::esdf
