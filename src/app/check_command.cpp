#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "app/arguments.hpp"
#include "app/commands.hpp"
#include "app/input_list.hpp"
#include "app/prediction.hpp"
#include "app/renderer_choice.hpp"
#include "core/counted.hpp"

namespace lichtraum::app {
namespace {

constexpr char const* check_description =
    "Reports what is wrong in scenes, and what render would write, and draws\n"
    "nothing. SCENE is an eSDF file, a model (glTF, OBJ, PLY, STL), or - for\n"
    "standard input. The exit status is the one that render would have with the\n"
    "same options.";

constexpr char const* check_examples =
    "  lichtraum check hello.sdf\n"
    "  lichtraum check --strict *.sdf\n"
    "  lichtraum check model.glb --orbit -35,20 --size 1280x720 -o left.png\n"
    "  lichtraum check -q --json hello.sdf\n"
    "  lichtraum check -v - < hello.sdf\n";

std::size_t count_of(std::vector<Diagnostic> const& diagnostics, Severity severity) {
  return static_cast<std::size_t>(std::count_if(diagnostics.begin(), diagnostics.end(),
                                                [&](Diagnostic const& d) { return d.severity == severity; }));
}

/// "would write a.png, 64x48, camera 'eye'"
std::string picture_text(PicturePlan const& plan) {
  Region const& region = *plan.job.region;
  std::string const camera = plan.job.camera.empty() ? "" : fmt::format(", camera '{}'", plan.job.camera);
  return fmt::format("would write {}, {}x{}{}", plan.output.shown, region.width, region.height, camera);
}

std::string film_line(std::vector<PicturePlan> const& plans, double rate) {
  return fmt::format("  {}: {}, {:.2f} s at {:g} a second\n", picture_text(plans.front()),
                     counted(plans.size(), "picture"), double(plans.size()) / rate, rate);
}

std::string picture_lines(std::vector<PicturePlan> const& plans) {
  std::string text;
  constexpr std::size_t most_pictures = 4;
  std::size_t const shown = std::min(plans.size(), most_pictures);
  for (std::size_t i = 0; i < shown; ++i) text += fmt::format("  {}\n", picture_text(plans[i]));
  if (std::size_t const more = plans.size() - shown; more > 0) {
    text += fmt::format("  and {}, the last is {}\n", counted(more, "more picture"), plans.back().output.shown);
  }
  return text;
}

std::string summary(Prediction const& prediction, double frame_rate) {
  std::size_t const errors = count_of(prediction.diagnostics, Severity::error);
  std::size_t const warnings = count_of(prediction.diagnostics, Severity::warning);
  std::string text = fmt::format("{}: {}", prediction.file, errors == 0 ? "good" : counted(errors, "error"));
  if (errors + warnings > 0) text += ", " + counted(warnings, "warning");
  text += "\n";
  auto const& plans = prediction.pictures;
  bool const is_film = !plans.empty() && plans.front().output.is_film;
  return text + (is_film ? film_line(plans, frame_rate) : picture_lines(plans));
}

/// False when only the help was asked for.
bool parse_check(Arguments const& arguments, RenderOptions& options, Console& console) {
  auto const parser = make_parser("check", check_description, check_examples);
  add_inputs(*parser, options.scenes, "SCENE...");
  add_file_options(*parser, options, "Output");
  parser->add_flag("--json", options.json, "Print JSON")->group("Output");
  add_picture_options(*parser, options);
  add_sequence_options(*parser, options);
  add_drawing_options(*parser, options);
  add_input_format_option(*parser, options.input_format);
  add_verbosity(*parser, console);
  if (!parse(*parser, arguments)) return false;
  check_inputs(options);
  return true;
}

}  // namespace

int check_command(Arguments const& arguments, Console& console) {
  RenderOptions options;
  if (!parse_check(arguments, options, console)) return 0;
  OutputNames names(options.output);
  std::vector<std::string> const inputs = expand_patterns(options.scenes);
  combine(options, inputs, names);
  auto const renderer = choose_renderer(options.device, options.traversal, console);
  options.load.set_drawing(options.job, renderer->device().kind);

  int code = 0;
  std::vector<Prediction> predictions;
  predict(inputs, options, names, *renderer, [&](Prediction const& prediction) {
    console.show(prediction.diagnostics);
    if (!console.is_quiet() && !options.json) write_standard_output(summary(prediction, options.frame_rate()));
    if (options.json) predictions.push_back(prediction);
    if (code == 0) code = prediction.exit_code;
  });
  if (options.json) write_standard_output(to_json(predictions, renderer->device()));
  return code;
}

}  // namespace lichtraum::app
