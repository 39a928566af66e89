#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "core/parse_number.hpp"
#include "io/esdf/color_range.hpp"
#include "io/esdf/environment_statement.hpp"
#include "io/esdf/interpreter.hpp"
#include "io/esdf/keys.hpp"
#include "io/esdf/statements.hpp"

// define light <name> [pos] [La] [Ld]
// define light diffuse <name> [pos] [Ld]
// define light ambient <name> [La]
// define light environment: see environment_statement.cpp
// A light with a position may have a size: [radius=<r>].
// Dialects: define light <name> [pos] [colour] <brightness>, and the rows of docs/ESDF.md.

namespace lichtraum::esdf {
namespace {

Signature const sdf_signature{{{"the position", 3}, {"La", 3}, {"Ld", 3}},
                              false,
                              {7, 6},
                              "define light <name> <x> <y> <z> <La: r g b> <Ld: r g b>"};
Signature const diffuse_signature{{{"the position", 3}, {"Ld", 3}}};
Signature const ambient_signature{{{"La", 3}}};
constexpr std::string_view light_kinds[] = {"diffuse", "ambient", "environment"};
constexpr std::size_t diffuse_numbers = 6;
constexpr std::size_t ambient_numbers = 3;

Rgb rgb(std::span<double const> v) { return Rgb(v[0], v[1], v[2]); }

/// What the numbers of a light mean.
enum class Form { position_la_ld, position_ld, position_color_brightness, la, ignored_position_la };

std::size_t number_count(Form form) {
  switch (form) {
    case Form::position_la_ld:
      return 9;
    case Form::position_color_brightness:
      return 7;
    case Form::position_ld:
    case Form::ignored_position_la:
      return 6;
    case Form::la:
      return 3;
  }
  return 0;
}

bool is_within_float(Rgb const& c) {
  double const largest = static_cast<double>(std::numeric_limits<float>::max());
  return std::abs(c.x) <= largest && std::abs(c.y) <= largest && std::abs(c.z) <= largest;
}

/// Whether colour times brightness is still a number on the device.
bool check_brightness(Interpreter& interpreter, Statement const& statement, Rgb const& color) {
  if (is_within_float(color)) return true;
  interpreter.error(Code::number_too_large, statement.last(), "colour times brightness is too large",
                    "single-precision numbers reach about 3.4e38");
  return false;
}

/// Where it takes light away.
void warn_of_brightness(Interpreter& interpreter, Token token, double value, char const* what) {
  if (value >= 0) return;
  interpreter.warning(Code::color_out_of_range, token, fmt::format("{}: the brightness is negative", what),
                      "0 is black");
}

/// Takes the keys off the end of a light with a position: its radius. The first arguments are `names`, whatever is in
/// them. Nothing, after a report, when it is none.
std::optional<double> take_radius(Interpreter& interpreter, Statement& statement, std::size_t names) {
  double radius = 0;
  Key const key{"radius",
                [&](Token value) {
                  auto const number = read_number(interpreter, value);
                  if (!number) return false;
                  radius = *number;
                  if (radius >= 0 && is_within_float(Rgb(radius))) return true;
                  interpreter.error(Code::out_of_range, value,
                                    fmt::format("light: the radius must be at least 0, not {}", in_quotes(value)),
                                    "0 is a point, as without a radius");
                  return false;
                },
                true};
  std::size_t const words = first_key(statement, names);
  if (!read_keys(interpreter, statement, words, std::span(&key, 1),
                 "define light diffuse <name> <x> <y> <z> <Ld: r g b> radius=<r>")) {
    return std::nullopt;
  }
  statement.arguments = statement.arguments.first(words);
  return radius;
}

/// `statement` is a name and the numbers of `form`; a radius is of lights with a position.
void define_light_as(Interpreter& interpreter, Statement const& statement, Form form, double radius = 0) {
  std::array<double, 9> v{};
  std::span<double> const values(v.data(), number_count(form));
  if (!read_numbers(interpreter, statement.arguments.subspan(1), values)) return;
  auto const check = [&](std::size_t first, char const* what, double largest) {
    check_color(interpreter, statement.arguments.subspan(1 + first, 3), values.subspan(first, 3), what, largest);
  };
  std::string name(statement[0]);
  Vec3 const position(v[0], v[1], v[2]);
  Rgb const first = rgb(values.first(3));
  auto const define_lamp = [&](Rgb const& ld, Rgb const& la = Rgb(0)) {
    PointLight const lamp{.ld = ld, .la = la, .position = position, .radius = radius};
    interpreter.define(statement[0], Light(std::move(name), lamp));
  };
  switch (form) {
    case Form::position_la_ld:
      check(3, "light: La", largest_share);
      check(6, "light: Ld", no_largest_share);
      define_lamp(rgb(values.subspan(6)), rgb(values.subspan(3)));
      break;
    case Form::position_ld:
      check(3, "light: Ld", no_largest_share);
      define_lamp(rgb(values.subspan(3)));
      break;
    case Form::position_color_brightness: {
      Rgb const ld = rgb(values.subspan(3)) * v[6];
      if (!check_brightness(interpreter, statement, ld)) return;
      check(3, "light: the colour", largest_share);
      warn_of_brightness(interpreter, statement.last(), v[6], "light");
      interpreter.scene.tone_map = ToneMap::reinhard;
      define_lamp(ld);
      break;
    }
    case Form::la:
      check(0, "light: La", largest_share);
      interpreter.define(statement[0], Light::ambient(std::move(name), first));
      break;
    case Form::ignored_position_la:
      check(3, "light: La", largest_share);
      interpreter.define(statement[0], Light::ambient(std::move(name), rgb(values.subspan(3))));
      break;
  }
}

/// A light without a class: `statement` starts with the name.
void define_plain(Interpreter& interpreter, Statement const& statement, double radius = 0) {
  if (statement.size() == 10) {
    define_light_as(interpreter, statement, Form::position_la_ld, radius);
  } else if (statement.size() == 8) {
    if (interpreter.dialect(statement.rest(0), "a light with colour and brightness")) {
      define_light_as(interpreter, statement, Form::position_color_brightness, radius);
    }
  } else if (statement.size() == 7) {
    if (interpreter.dialect(statement.rest(0), "a light with a position and one colour")) {
      define_light_as(interpreter, statement, Form::position_ld, radius);
    }
  } else {
    report_wrong_count(interpreter, statement, sdf_signature);
  }
}

/// `outer` starts with the word 'diffuse', `statement` after it.
void define_diffuse(Interpreter& interpreter, Statement const& outer, Statement const& statement, double radius) {
  bool const has_name = statement.size() > 0 && !looks_like_number(statement[0]);
  if (statement.size() == 7) {
    define_light_as(interpreter, statement, Form::position_ld, radius);
  } else if (statement.size() == 10) {
    if (interpreter.dialect(statement.rest(0), "a diffuse light with La")) {
      define_light_as(interpreter, statement, Form::position_la_ld, radius);
    }
  } else if (!has_name && (statement.size() == 9 || statement.size() == 6)) {
    define_plain(interpreter, outer, radius);  // a light that is called 'diffuse'
  } else {
    report_wrong_count(interpreter, {"diffuse light", statement.keyword, statement.arguments}, diffuse_signature);
  }
}

/// `outer` starts with the word 'ambient', `statement` after it.
void define_ambient_light(Interpreter& interpreter, Statement const& outer, Statement const& statement) {
  std::string const hint = "ambient light is written: define light ambient <name> <r> <g> <b>";
  std::string const no_position =
      fmt::format("ambient light has no position{}",
                  interpreter.options.strict ? "" : ": only the last three numbers count, as La");
  bool const has_name = statement.size() > 0 && !looks_like_number(statement[0]);
  std::size_t const numbers = statement.size() - (has_name ? 1 : 0);
  Statement const& named = has_name ? statement : outer;  // without a name it is called 'ambient'
  if (statement.size() == 4) {
    define_light_as(interpreter, statement, Form::la);
  } else if (numbers == 9) {
    std::string const message = "this is a point light with a position, La and Ld";
    if (!has_name) {
      interpreter.warning(Code::ambient_light_form, named.rest(0), message + ", called 'ambient'",
                          hint);  // the standard's form
      define_light_as(interpreter, named, Form::position_la_ld);
    } else if (interpreter.dialect_warning(Code::ambient_light_form, named.rest(0), message, hint)) {
      define_light_as(interpreter, named, Form::position_la_ld);
    }
  } else if (numbers == 6) {
    if (interpreter.dialect_warning(Code::ambient_light_form, named.rest(0), no_position, hint)) {
      define_light_as(interpreter, named, Form::ignored_position_la);
    }
  } else if (numbers == 7 && !has_name) {
    define_plain(interpreter, outer);  // colour and brightness of a light that is called 'ambient'
  } else {
    report_wrong_count(interpreter, {"ambient light", statement.keyword, statement.arguments}, ambient_signature);
  }
}

/// `outer` starts with the word 'environment', `statement` after it.
void define_environment_light(Interpreter& interpreter, Statement const& outer, Statement const& statement) {
  auto const& words = statement.arguments;
  bool const is_name = (words.size() == 9 || words.size() == 7 || words.size() == 6) &&
                       std::all_of(words.begin(), words.end(), looks_like_number);
  if (is_name) {
    define_plain(interpreter, outer);  // a light that is called 'environment'
  } else if (interpreter.dialect(outer.rest(0), "an environment")) {
    define_environment(interpreter, {"environment light", statement.keyword, words});
  }
}

/// Whether there is a word before the name that is no kind of light, which is then reported: a word is where the first
/// number would be, and it is near a kind, or only with a kind does the count come out.
bool report_unknown_kind(Interpreter& interpreter, Statement const& statement) {
  if (statement.size() < 2 || looks_like_number(statement[1])) return false;
  if (std::ranges::find(light_kinds, statement[0]) != std::end(light_kinds)) return false;
  std::string const hint = interpreter.suggest(statement[0], light_kinds);
  std::size_t const numbers = first_key(statement, 2) - 2;
  if (hint.empty() && numbers != diffuse_numbers && numbers != ambient_numbers) return false;
  interpreter.error(Code::unknown_light, statement[0], fmt::format("light: unknown kind {}", in_quotes(statement[0])),
                    hint.empty() ? "the kinds are diffuse, ambient and environment" : hint);
  return true;
}

/// A name for an ambient light that was given none. It has a blank, so that no file can use it.
std::string free_ambient_name(Scene const& scene) { return fmt::format("ambient light {}", scene.lights.size() + 1); }

void read_light(Interpreter& interpreter, Statement const& statement) {
  if (report_unknown_kind(interpreter, statement)) return;
  Token const word = statement.size() > 0 ? statement[0] : Token();
  auto const after_word = [&](Statement const& outer) {
    return Statement{outer.what, word, outer.arguments.subspan(1)};
  };
  if (word == "ambient") return define_ambient_light(interpreter, statement, after_word(statement));
  if (word == "environment") return define_environment_light(interpreter, statement, after_word(statement));
  Statement lamp = statement;
  auto const radius = take_radius(interpreter, lamp, word == "diffuse" ? 2 : 1);
  if (!radius) return;
  if (word == "diffuse") return define_diffuse(interpreter, lamp, after_word(lamp), *radius);
  define_plain(interpreter, lamp, *radius);
}

}  // namespace

void define_light(Interpreter& interpreter, Statement const& statement) {
  read_light(interpreter, statement);
  auto const& words = statement.arguments;
  std::size_t const place =
      words.size() > 1 && std::ranges::find(light_kinds, words[0]) != std::end(light_kinds) ? 1 : 0;
  bool const is_named = place < words.size() && !looks_like_number(words[place]);
  if (is_named && !interpreter.is_light(words[place])) interpreter.mark_faulty(Kind::light, words[place]);
}

// ambient [rgb], ambient <name> [rgb] [<brightness>], ambient <value>; all of it also after `define`.
void define_ambient(Interpreter& interpreter, Statement const& statement) {
  std::size_t const size = statement.size();
  bool const has_name = size == 4 || size == 5;
  if (!has_name && size != 1 && size != 3) {
    interpreter.error(Code::wrong_count, size > 5 ? statement.rest(5) : place_after(statement.last()),
                      fmt::format("ambient: expected 3 numbers, found {} argument{}", size, size == 1 ? "" : "s"),
                      "ambient <r> <g> <b>, optionally with a name before and a brightness after");
    return;
  }
  std::array<double, 4> v{0, 0, 0, 1};
  std::size_t const first = has_name ? 1 : 0;
  if (!read_numbers(interpreter, statement.arguments.subspan(first), v)) return;
  Rgb const la = size == 1 ? Rgb(v[0]) : Rgb(v[0], v[1], v[2]) * v[3];
  if (!check_brightness(interpreter, statement, la)) return;
  std::size_t const channels = size == 1 ? 1 : 3;
  check_color(interpreter, statement.arguments.subspan(first, channels), std::span(v).first(channels), "ambient",
              largest_share);
  warn_of_brightness(interpreter, statement.last(), v[3], "ambient");
  if (size == 5) interpreter.scene.tone_map = ToneMap::reinhard;
  if (has_name) {
    interpreter.define(statement[0], Light::ambient(std::string(statement[0]), la));
  } else {
    std::string const name = free_ambient_name(interpreter.scene);
    interpreter.define(name, Light::ambient(name, la));
  }
}

}  // namespace lichtraum::esdf
