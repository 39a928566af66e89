#pragma once

#include <CLI/App.hpp>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "app/console.hpp"
#include "lichtraum/error.hpp"
#include "lichtraum/job.hpp"

/// What the subcommands' command lines have in common.

namespace lichtraum::app {

/// A parser with lichtraum's layout of --help. `command` is "render", `examples` the end of its help.
std::unique_ptr<CLI::App> make_parser(std::string const& command, std::string const& description,
                                      std::string const& examples);

/// Parses what follows the subcommand. Prints the help and returns false when asked for it. Throws Error{usage} with
/// one line that says what is wrong and what to do.
bool parse(CLI::App& parser, std::vector<std::string> arguments);

/// The value that an option has in `text`. Throws Error{usage} for what `parse_value` refuses.
template <class Parse>
auto value_of(std::string const& option, std::string const& text, Parse const& parse_value) {
  try {
    return parse_value(text);
  } catch (std::invalid_argument const& error) {
    throw Error(ErrorKind::usage, option + ": " + error.what() + ", not '" + text + "'");
  }
}

/// An option with one value (the last one given counts). `parse_value` makes it from text, and throws
/// std::invalid_argument that says what it expects.
template <class Target, class Parse>
void add_value(CLI::App& parser, std::string const& names, Target& target, Parse parse_value,
               std::string const& value_name, std::string const& description, std::string const& group) {
  std::string const long_name = names.substr(names.find("--"));
  parser
      .add_option_function<std::string>(
          names,
          [&target, parse_value, long_name](std::string const& text) {
            target = value_of(long_name, text, parse_value);
          },
          description)
      ->type_name(value_name)
      ->take_last()
      ->group(group);
}

/// An option whose value may be left out; `parse_value` gets "true" then. It never takes the next word for its value:
/// that is given by --name=VALUE.
template <class Target, class Parse>
void add_flag_or_value(CLI::App& parser, std::string const& name, Target& target, Parse parse_value,
                       std::string const& description, std::string const& group) {
  auto const text = std::make_shared<std::string>();
  parser.add_flag(name, *text, description)
      ->each(
          [text, &target, parse_value, name](std::string const& value) { target = value_of(name, value, parse_value); })
      ->take_last()
      ->group(group);
}

/// The words that are not options: one for a string, any number for a vector. `placeholder` stands for them in the
/// help. CLI11's own name for them must be no option's, which 2.2 and later insist on.
template <class Target>
void add_inputs(CLI::App& parser, Target& target, std::string const& placeholder) {
  parser.add_option("inputs", target)->required()->type_name(placeholder);
}

/// A text that is taken as it is, but not empty.
std::string parse_name(std::string_view text);

/// -q and -v.
void add_verbosity(CLI::App& parser, Console& console);

/// How eSDF files are read: --strict, --keep-going, --transform-order, --rotation, --material-extras, --allow-path.
void add_language_options(CLI::App& parser, SceneReading& reading);

/// How models are read: --scene, --variant, --time, --animation, --both-sides, --point-size, --max-texture.
void add_model_options(CLI::App& parser, ModelChoice& choice);

/// What standard input is: --format-in.
void add_input_format_option(CLI::App& parser, std::string& format);
/// Throws Error{usage} where a format was given and none of the inputs is standard input.
void check_input_format(std::string const& format, std::vector<std::string> const& inputs);

/// The known word nearest to a misspelt one; empty when none is near.
std::string nearest(std::string_view word, std::vector<std::string> const& known);

}  // namespace lichtraum::app
