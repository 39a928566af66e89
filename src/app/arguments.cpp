#include "app/arguments.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <utility>

#include "app/values.hpp"
#include "core/edit_distance.hpp"

namespace lichtraum::app {
namespace {

/// CLI11's layout with less on each line: `--size WxH`, without types, counts and defaults.
class Formatter final : public CLI::Formatter {
 public:
  Formatter() { column_width(30); }
  std::string make_option_opts(CLI::Option const* option) const override {
    return option->get_type_size() == 0 ? "" : " " + option->get_type_name();
  }
  std::string make_usage(CLI::App const* app, std::string) const override {
    std::string text = "\nUsage: " + app->get_name() + " [OPTION]...";
    for (CLI::Option const* const option : app->get_options()) {
      if (option->get_positional()) text += fmt::format(" {}", option->get_type_name());
    }
    return text + "\n\n";
  }
  std::string make_group(std::string group, bool is_positional,
                         std::vector<CLI::Option const*> options) const override {
    std::string text = CLI::Formatter::make_group(group, is_positional, options);
    text.erase(0, text.find_first_not_of('\n'));
    return text;
  }
  // They are in the usage line, and the description says what they are.
  std::string make_positionals(CLI::App const*) const override { return ""; }
  std::string make_footer(CLI::App const* app) const override { return "Examples:\n" + app->get_footer(); }
};

std::vector<std::string> option_names(CLI::App const& parser) {
  std::vector<std::string> names;
  for (CLI::Option const* const option : parser.get_options()) {
    for (std::string const& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

/// What an option of other programs is called in this one; empty for others.
std::string name_here(std::string_view option) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 5> names{{{"--width", "--size"},
                                                                                {"--height", "--size"},
                                                                                {"--spp", "--samples"},
                                                                                {"--out", "--output"},
                                                                                {"--output-file", "--output"}}};
  auto const name = std::ranges::find(names, option, [](auto const& pair) { return pair.first; });
  return name == names.end() ? std::string() : std::string(name->second);
}

[[noreturn]] void fail(CLI::App const& parser, std::string const& what) {
  throw Error(ErrorKind::usage, fmt::format("{} ({} --help shows how)", what, parser.get_name()));
}

void refuse_unknown_options(CLI::App const& parser) {
  std::vector<std::string> unknown = parser.remaining();
  std::erase(unknown, "--");  // CLI11 takes what follows for files, and leaves the mark itself
  if (unknown.empty()) return;
  std::string const option = unknown.front().substr(0, unknown.front().find('='));
  if (option.empty() || option.front() != '-') fail(parser, fmt::format("unexpected argument '{}'", option));
  auto const names = option_names(parser);
  std::string suggestion = name_here(option);
  if (std::ranges::find(names, suggestion) == names.end()) suggestion = nearest(option, names);
  if (suggestion.empty()) fail(parser, fmt::format("there is no option '{}'", option));
  fail(parser, fmt::format("there is no option '{}': did you mean {}?", option, suggestion));
}

/// CLI11 takes the next word for the value of an option whose own is empty, as in --output-dir="$UNSET".
void refuse_empty_values(CLI::App const& parser, std::vector<std::string> const& arguments) {
  for (std::string const& word : arguments) {
    if (word == "--") return;
    if (!word.starts_with("--") || word.find('=') != word.size() - 1) continue;
    std::string const option = word.substr(0, word.size() - 1);
    if (parser.get_option_no_throw(option)) fail(parser, fmt::format("{}: expected a value, not ''", option));
  }
}

}  // namespace

std::string nearest(std::string_view word, std::vector<std::string> const& known) {
  std::string best;
  std::size_t best_distance = likely_slips(word) + 1;
  for (std::string const& candidate : known) {
    std::size_t const distance = edit_distance(word, candidate, best_distance);
    if (distance < best_distance) {
      best = candidate;
      best_distance = distance;
    }
  }
  return best;
}

std::unique_ptr<CLI::App> make_parser(std::string const& command, std::string const& description,
                                      std::string const& examples) {
  auto parser = std::make_unique<CLI::App>(description, "lichtraum " + command);
  parser->formatter(std::make_shared<Formatter>());
  parser->footer(examples);
  parser->allow_extras();   // they are reported in our own words
  parser->set_help_flag();  // added last, see parse
  return parser;
}

bool parse(CLI::App& parser, std::vector<std::string> arguments) {
  parser.set_help_flag("-h,--help", "Show this help")->group("General");
  refuse_empty_values(parser, arguments);
  std::reverse(arguments.begin(), arguments.end());  // CLI11 takes them from the back
  try {
    parser.parse(arguments);
  } catch (CLI::CallForHelp const&) {
    write_standard_output(parser.help());
    return false;
  } catch (CLI::RequiredError const&) {
    refuse_unknown_options(parser);
    fail(parser, parser.get_option("inputs")->get_type_name() == "DIR" ? "no folder is given" : "no file is given");
  } catch (CLI::ArgumentMismatch const& error) {
    refuse_unknown_options(parser);
    std::string const text = error.what();
    fail(parser, fmt::format("{} needs a value", text.substr(0, text.find(':'))));
  } catch (CLI::ParseError const& error) {
    refuse_unknown_options(parser);
    fail(parser, error.what());
  }
  refuse_unknown_options(parser);
  return true;
}

std::string parse_name(std::string_view text) {
  if (text.empty()) throw std::invalid_argument("expected a name");
  return std::string(text);
}

void add_verbosity(CLI::App& parser, Console& console) {
  parser
      .add_flag_callback(
          "-q,--quiet", [&] { console.set_verbosity(Verbosity::quiet); }, "Print errors only")
      ->group("General");
  parser
      .add_flag_callback(
          "-v,--verbose", [&] { console.set_verbosity(Verbosity::verbose); }, "Print more: notes, timings")
      ->group("General");
}

void add_language_options(CLI::App& parser, SceneReading& reading) {
  EsdfDialect& dialect = reading.dialect;
  std::string const group = "Scene language";
  parser.add_flag("--strict", dialect.strict, "Accept the standard only, no dialects")->group(group);
  parser.add_flag("--keep-going", dialect.keep_going, "Leave faulty statements out and go on")->group(group);
  add_value(parser, "--transform-order", dialect.transform_order, parse_transform_order, "ORDER",
            "Frame that transforms apply in: parent\n(default) or local", group);
  add_value(parser, "--rotation", dialect.rotation, parse_rotation, "SENSE",
            "Rotations are right- (default) or left-handed:\nright or left", group);
  add_value(parser, "--material-extras", dialect.material_extras, parse_material_extras, "WORDS",
            "What numbers after a material's m mean, such as\nopacity,ior; words: reflectance,\ntransmittance, "
            "opacity, ior, ignore",
            group);
  parser
      .add_option_function<std::vector<std::string>>(
          "--allow-path",
          [&reading](std::vector<std::string> const& folders) {
            for (std::string const& folder : folders) {
              reading.allowed_paths.emplace_back(value_of("--allow-path", folder, parse_name));
            }
          },
          "Folder that a scene may read and write besides\nits own (may be repeated)")
      ->type_name("FOLDER")
      ->allow_extra_args(false)
      ->group(group);
}

void add_model_options(CLI::App& parser, ModelChoice& choice) {
  std::string const group = "Models";
  add_value(parser, "--scene", choice.scene, parse_name, "NAME", "Scene of the file: name, or number from 0", group);
  add_value(parser, "--variant", choice.variant, parse_name, "NAME",
            "Variant of the materials: name, or number from 0\n(default: as the meshes are)", group);
  add_value(parser, "--time", choice.time_seconds, parse_time, "SECONDS", "Show the animation at this time", group);
  add_value(parser, "--animation", choice.animation, parse_name, "NAME",
            "Animation that --time, --frames and films show:\nname, or number from 0 (default: the first)", group);
  parser
      .add_flag("--both-sides", choice.both_sides,
                "Show the camera the backs of single-sided\nsurfaces (paths; glTF hides them)")
      ->group(group);
  add_value(parser, "--max-texture", choice.max_texture, parse_texture_size, "N",
            "Shrink textures with a longer side\n(default: 4096)", group);
  add_value(parser, "--point-size", choice.point_size, parse_point_size, "SIZE",
            "Diameter of points and lines, in thousandths of\nthe model's diagonal (default: by their number)", group);
}

void add_input_format_option(CLI::App& parser, std::string& format) {
  add_value(parser, "--format-in", format, parse_input_format, "NAME",
            "What standard input is: sdf, gltf, glb, obj, ply\nor stl (default: glb, obj, ply and stl are\nrecognised, "
            "anything else is sdf)",
            "Models");
}

void check_input_format(std::string const& format, std::vector<std::string> const& inputs) {
  if (format.empty() || std::find(inputs.begin(), inputs.end(), "-") != inputs.end()) return;
  throw Error(ErrorKind::usage, "--format-in is for standard input (-): the format of a file is told by its extension");
}

}  // namespace lichtraum::app
