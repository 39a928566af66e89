#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "app/arguments.hpp"
#include "app/commands.hpp"
#include "app/exit_code.hpp"
#include "app/scene_source.hpp"

namespace lichtraum::app {
namespace {

constexpr char const* description =
    "Reports what is wrong in scenes and draws nothing. SCENE is an eSDF file, a\n"
    "model (glTF, OBJ, PLY, STL), or - for standard input.";

constexpr char const* examples =
    "  lichtraum check hello.sdf\n"
    "  lichtraum check --strict *.sdf\n"
    "  lichtraum check model.glb\n"
    "  lichtraum check -v - < hello.sdf\n";

std::string count(std::size_t number, std::string_view what) {
  return fmt::format("{} {}{}", number, what, number == 1 ? "" : "s");
}

std::size_t count_of(std::vector<Diagnostic> const& diagnostics, Severity severity) {
  return static_cast<std::size_t>(std::count_if(diagnostics.begin(), diagnostics.end(),
                                                [&](Diagnostic const& d) { return d.severity == severity; }));
}

std::string summary(std::string const& name, std::vector<Diagnostic> const& diagnostics) {
  std::size_t const errors = count_of(diagnostics, Severity::error);
  std::size_t const warnings = count_of(diagnostics, Severity::warning);
  if (errors + warnings == 0) return fmt::format("{}: good\n", name);
  std::string const text = errors == 0 ? "good, " : count(errors, "error") + ", ";
  return fmt::format("{}: {}{}\n", name, text, count(warnings, "warning"));
}

}  // namespace

int check_command(Arguments const& arguments, Console& console) {
  std::vector<std::string> scenes;
  std::string input_format;
  SceneReading reading;
  auto const parser = make_parser("check", description, examples);
  add_inputs(*parser, scenes, "SCENE...");
  add_language_options(*parser, reading);
  add_model_options(*parser, reading.model);
  add_input_format_option(*parser, input_format);
  add_verbosity(*parser, console);
  if (!parse(*parser, arguments)) return 0;
  check_input_format(input_format, scenes);

  int code = 0;
  for (std::string const& scene : scenes) {
    std::string line;
    try {
      LoadedScene const script = SceneSource(scene, input_format).load(reading);
      console.show(script.diagnostics());
      line = summary(scene, script.diagnostics());
    } catch (SceneError const& error) {
      console.show(error);
      line = summary(scene, error.diagnostics());
      if (code == 0) code = exit_code(error.kind());
    } catch (Error const& error) {
      console.show(error);
      if (code == 0) code = exit_code(error.kind());
    }
    if (!console.is_quiet()) write_standard_output(line);
  }
  return code;
}

}  // namespace lichtraum::app
