#include "io/esdf/environment_statement.hpp"

#include <fmt/format.h>

#include <array>
#include <optional>

#include "core/parse_number.hpp"
#include "io/esdf/interpreter.hpp"
#include "io/esdf/keys.hpp"
#include "io/esdf/named_file.hpp"

// define light environment <name> <file>|studio|[rgb] [rotation=<degrees>] [brightness=<x>]

namespace lichtraum::esdf {
namespace {

constexpr std::string_view environment_usage =
    "define light environment <name> <file, studio or r g b> [rotation=<degrees>] [brightness=<x>]";

/// The same from everywhere. Nothing, after a report, when the numbers are none.
std::optional<EnvironmentLight> read_color(Interpreter& interpreter, std::span<Token const> numbers) {
  auto const color = read_radiance(interpreter, numbers, "environment light: radiance");
  if (!color) return std::nullopt;
  return EnvironmentLight{std::string(span_of(numbers.front(), numbers.back())),
                          uniform_environment(float(color->x), float(color->y), float(color->z))};
}

/// From a file, or built in. Nothing, after a report, when it cannot be used.
std::optional<EnvironmentLight> read_map(Interpreter& interpreter, Token word) {
  std::string source(word);
  if (word != "studio") {
    auto const path = find_named_file(interpreter, word);
    if (!path) return std::nullopt;
    source = path->string();
    if (interpreter.options.on_read) interpreter.options.on_read(*path);
  }
  try {
    return EnvironmentLight{source, interpreter.options.find_environment(source)};
  } catch (Error const& problem) {
    interpreter.error(Code::unreadable_file, word, fmt::format("cannot read {}: {}", in_quotes(word), problem.what()),
                      problem.kind() == ErrorKind::no_input
                          ? "a map's place is relative to the scene's; without one, there is the built-in 'studio'"
                          : "");
  }
  return std::nullopt;
}

/// What fills `light`.
auto keys_of(Interpreter& interpreter, EnvironmentLight& light) {
  return std::to_array<Key>({{"rotation",
                              [&](Token value) {
                                auto const degrees = read_number(interpreter, value);
                                if (degrees) light.rotation_degrees = *degrees;
                                return degrees.has_value();
                              }},
                             {"brightness", [&](Token value) {
                                auto const brightness = read_number(interpreter, value);
                                if (!brightness) return false;
                                light.brightness = *brightness;
                                if (*brightness >= 0 && *brightness <= max_environment_brightness) return true;
                                interpreter.error(
                                    Code::out_of_range, value,
                                    fmt::format("environment light: brightness must lie between 0 and {}, not {}",
                                                max_environment_brightness, in_quotes(value)));
                                return false;
                              }}});
}

}  // namespace

void define_environment(Interpreter& interpreter, Statement const& statement) {
  auto const& arguments = statement.arguments;
  std::size_t const words = first_key(statement, 1);
  if (words != 2 && words != 4) {
    interpreter.error(Code::wrong_count,
                      words > 4 ? statement.rest(4) : place_after(words > 0 ? arguments[words - 1] : statement.keyword),
                      "environment light: expected a name, and a file, studio or 3 numbers",
                      std::string(environment_usage));
    return;
  }
  EnvironmentLight given;
  auto const keys = keys_of(interpreter, given);
  bool const has_good_keys = read_keys(interpreter, statement, words, keys, std::string(environment_usage));
  auto light = words == 4 ? read_color(interpreter, arguments.subspan(1, 3)) : read_map(interpreter, arguments[1]);
  if (!light || !has_good_keys) return;
  light->rotation_degrees = given.rotation_degrees;
  light->brightness = given.brightness;
  light->name = arguments[0];
  interpreter.define(arguments[0], std::move(*light));
}

}  // namespace lichtraum::esdf
