#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstring>

#include "app/arguments.hpp"
#include "app/values.hpp"
#include "app/view_options.hpp"
#include "lichtraum/gltf.hpp"

namespace lichtraum::app {
namespace {

constexpr char const* view_description =
    "Opens a window on a scene: turn it with the mouse, press ? for the keys. SCENE\n"
    "is an eSDF file or a model (glTF, OBJ, PLY, STL).";

constexpr char const* view_examples =
    "  lichtraum view hello.sdf\n"
    "  lichtraum view hello.sdf --watch\n"
    "  lichtraum view model.glb --time 1.5 --size 1280x720\n";

/// The window is a program of its own, so that this one needs no display's libraries.
std::filesystem::path window_program() {
  std::error_code error;
  return std::filesystem::read_symlink("/proc/self/exe", error).parent_path() / "lichtraum-view";
}

std::unique_ptr<CLI::App> view_parser(ViewOptions& options, Console& console) {
  RenderOptions& render = options.render;
  auto parser = make_parser("view", view_description, view_examples);
  add_inputs(*parser, options.scene, "SCENE");
  std::string const group = "Window";
  parser
      ->add_flag("--watch", options.watch,
                 "Read the scene again when its file, or one that it\nincludes, is saved. Mistakes in it are shown in\n"
                 "the window, which waits for them to be mended")
      ->group(group);
  add_value(*parser, "--size", render.job.size, parse_size, "WxH",
            "Size of the window in pixels (default: the\nscene's)", group);
  add_value(*parser, "--ui-scale", options.ui_scale, parse_ui_scale, "FACTOR",
            "Size of text and widgets, 0.5 to 8 (default: as\nthe display asks for)", group);
  add_viewpoint_options(*parser, render, group);
  add_environment_options(*parser, render.job.reading.environment);
  add_quality_options(*parser, render, "256");
  add_denoise_option(*parser, render.job.denoising);
  add_language_options(*parser, render.job.reading);
  add_model_options(*parser, render.job.reading.model);
  add_verbosity(*parser, console);
  return parser;
}

}  // namespace

Arguments arguments_for_view(CLI::App const& parser) {
  ViewOptions options;
  Console console;
  auto const known = view_parser(options, console);
  Arguments arguments;
  for (CLI::Option const* const option : parser.get_options()) {
    if (option->empty() || option->get_lnames().empty()) continue;
    std::string const name = "--" + option->get_lnames().front();
    if (!known->get_option_no_throw(name)) continue;
    bool const is_flag = option->get_type_size() == 0;
    for (std::string const& value : option->results())
      arguments.push_back(is_flag && value == "true" ? name : name + "=" + value);
  }
  return arguments;
}

bool parse_view(Arguments const& arguments, ViewOptions& options, Console& console) {
  auto const parser = view_parser(options, console);
  if (!parse(*parser, arguments)) return false;
  if (options.scene == "-") throw Error(ErrorKind::usage, "a window needs a file, not standard input");
  return true;
}

int view_command(Arguments const& arguments, Console& console) {
  ViewOptions options;
  if (!parse_view(arguments, options, console)) return 0;
  if (::access(options.scene.c_str(), R_OK) != 0) {
    throw Error(ErrorKind::no_input, fmt::format("cannot open '{}': {}", options.scene, std::strerror(errno)));
  }  // which the window would say as well, but not without a display
  become_window(arguments);
}

void become_window(Arguments const& arguments) {
  std::string const program = window_program().string();
  std::vector<char*> words{const_cast<char*>(program.c_str())};
  for (std::string const& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
  words.push_back(nullptr);
  ::execv(program.c_str(), words.data());
  if (errno == ENOENT) {
    throw Error(
        ErrorKind::unavailable,
        fmt::format("there is no '{}': the window is left out of builds that find no libglfw3-dev, libgl-dev and "
                    "libimgui-dev (lichtraum preview shows a scene in the terminal)",
                    program));
  }
  throw Error(ErrorKind::unavailable, fmt::format("cannot start '{}': {}", program, std::strerror(errno)));
}

}  // namespace lichtraum::app
