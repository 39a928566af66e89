#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "app/arguments.hpp"
#include "app/commands.hpp"
#include "app/input_list.hpp"
#include "app/renderer_choice.hpp"
#include "app/sequence.hpp"
#include "app/stopwatch.hpp"
#include "app/values.hpp"
#include "app/video.hpp"
#include "app/view_options.hpp"

namespace lichtraum::app {
namespace {

constexpr char const* render_description =
    "Draws scenes to pictures. SCENE is an eSDF file, a model (.gltf, .glb, .obj,\n"
    ".ply, .stl), - for standard input, or a pattern in quotes, such as\n"
    "'frames/*.sdf'. A scene names its pictures itself; one that does not, and a\n"
    "model, is drawn to <scene>.png.";

constexpr char const* render_examples =
    "  lichtraum render hello.sdf\n"
    "  lichtraum render hello.sdf -o hello.exr --size 1920x1080 --samples 4x4\n"
    "  lichtraum render model.glb --time 1.5 -o model.png\n"
    "  lichtraum render film.sdf -o frames/%04d.png --resume\n"
    "  lichtraum render 'frames/*.sdf' -o film.mp4 --fps 30\n"
    "  lichtraum render model.glb --orbit -35,20 --size 1280x720 -o left.png\n"
    "  lichtraum render model.glb --turntable 90 -o around.webm\n"
    "  lichtraum render hello.sdf --planes radiance,depth,normal -o planes.exr\n"
    "  lichtraum render old.sdf --rotation left --transform-order local\n"
    "  lichtraum render hello.sdf --samples 64 --show\n"
    "  lichtraum render - -o - --format ppm < hello.sdf > hello.ppm\n"
    "  lichtraum render - --format-in glb -o model.png < model.glb\n"
    "  lichtraum render a.sdf b.sdf --output-dir pictures --json -q\n";

void add_output_options(CLI::App& parser, RenderOptions& options) {
  std::string const group = "Output";
  add_file_options(parser, options, group);
  parser.add_flag("--show", options.show, "Then open a window on the scene")->group(group);
  parser
      .add_flag("--json", options.json, "Print statistics as JSON, to standard output\n(to standard error with -o -)")
      ->group(group);
}

/// `window_arguments`: with --show, what `lichtraum view` is told besides the scene.
bool parse_render(Arguments const& arguments, RenderOptions& options, Arguments& window_arguments, Console& console) {
  auto const parser = make_parser("render", render_description, render_examples);
  add_inputs(*parser, options.scenes, "SCENE...");
  add_output_options(*parser, options);
  add_picture_options(*parser, options);
  add_sequence_options(*parser, options);
  parser
      ->add_flag("--resume", options.resume,
                 "Skip pictures that exist already, drawn from the\nsame scene with the same settings (.png, .exr)")
      ->group("Sequences and films");
  add_drawing_options(*parser, options);
  add_input_format_option(*parser, options.input_format);
  add_verbosity(*parser, console);
  if (!parse(*parser, arguments)) return false;
  if (options.show) window_arguments = arguments_for_view(*parser);

  check_inputs(options);
  return true;
}

/// Throws Error{usage} for what a window cannot show.
void check_show(RenderOptions const& options, std::vector<std::string> const& inputs, OutputNames const& names) {
  auto const refuse = [](std::string const& why) { throw Error(ErrorKind::usage, "--show: " + why); };
  if (inputs.size() != 1) refuse("a window shows one scene");
  if (inputs.front() == "-") refuse("a window needs a file, not standard input");
  if (names.is_film() || options.frames || options.turntable > 0)
    refuse("a window shows no films, --frames, --turntable");
  if (options.job.region) refuse("a window shows whole pictures, not a --region");
  if (options.job.planes != PlaneSet{FilmPlane::radiance})
    refuse("a window begins with the picture, not with other --planes");
}

}  // namespace

int render_command(Arguments const& arguments, Console& console) {
  RenderOptions options;
  Arguments window_arguments;
  if (!parse_render(arguments, options, window_arguments, console)) return 0;
  OutputNames names(options.output);
  std::vector<std::string> const inputs = expand_patterns(options.scenes);
  combine(options, inputs, names);
  if (options.show) check_show(options, inputs, names);

  Stopwatch const stopwatch;
  auto const renderer = choose_renderer(options.device, options.traversal, console);
  console.detail(fmt::format("device {}: {}", renderer->device().index, renderer->device().name));
  options.load.set_drawing(options.job, renderer->device().kind);
  RunReport report;
  report.device = renderer->device();
  // The report follows on standard error, where nothing else belongs that it tells, too.
  bool const is_report_on_error = options.json && options.output.file == "-";
  Console of_drawing = console;
  if (is_report_on_error && !console.is_verbose()) of_drawing.set_verbosity(Verbosity::silent);
  int const code = draw_sequence(inputs, options, names, *renderer, of_drawing, report);
  report.total_ms = stopwatch.milliseconds();
  if (options.json) {
    std::string const json = to_json(report);
    is_report_on_error ? console.data(json) : write_standard_output(json);
  }
  if (options.show && code == 0) {
    window_arguments.push_back(inputs.front());
    become_window(window_arguments);
  }
  return code;
}

}  // namespace lichtraum::app
