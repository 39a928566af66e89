#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "app/arguments.hpp"
#include "app/commands.hpp"
#include "app/scene_source.hpp"
#include "app/scene_summary.hpp"

namespace lichtraum::app {
namespace {

constexpr char const* info_description =
    "Describes a scene as it is at the end of the file. FILE is an eSDF file,\n"
    "a model (glTF, OBJ, PLY, STL), or - for standard input.";

constexpr char const* info_examples =
    "  lichtraum info hello.sdf\n"
    "  lichtraum info hello.sdf --json\n"
    "  lichtraum info model.glb\n";

}  // namespace

int info_command(Arguments const& arguments, Console& console) {
  std::string file;
  bool json = false;
  std::string input_format;
  SceneReading reading;
  auto const parser = make_parser("info", info_description, info_examples);
  add_inputs(*parser, file, "FILE");
  parser->add_flag("--json", json, "Print JSON")->group("Output");
  add_language_options(*parser, reading);
  add_model_options(*parser, reading.model);
  add_input_format_option(*parser, input_format);
  add_verbosity(*parser, console);
  if (!parse(*parser, arguments)) return 0;
  check_input_format(input_format, {file});

  SceneSource const source(file, input_format);
  LoadedScene const script = source.load(reading);
  console.show(script.diagnostics());
  SceneSummary summary = summarise(script.scene(), source.job({}));
  summary.contents = script.contents();
  write_standard_output(json ? to_json(summary, source.name()) : to_text(summary, source.name()));
  return 0;
}

}  // namespace lichtraum::app
