#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstring>

#include "app/arguments.hpp"
#include "app/view_options.hpp"
#include "lichtraum/gltf.hpp"

namespace lichtraum::app {
namespace {

constexpr char const* description =
    "Opens a window on a scene: turn it with the mouse, press ? for the keys. SCENE\n"
    "is an eSDF file or a glTF model.";

constexpr char const* examples =
    "  lichtraum view hello.sdf\n"
    "  lichtraum view hello.sdf --watch\n"
    "  lichtraum view model.glb --time 1.5 --size 1280x720\n";

/// The window is a program of its own, so that this one needs no display's libraries.
std::filesystem::path window_program() {
  std::error_code error;
  return std::filesystem::read_symlink("/proc/self/exe", error).parent_path() / "lichtraum-view";
}

}  // namespace

bool parse_view(Arguments const& arguments, ViewOptions& options, Console& console) {
  RenderOptions& render = options.render;
  auto const parser = make_parser("view", description, examples);
  parser->add_option("scene", options.scene, "an eSDF file, a glTF model")->required()->type_name("SCENE");
  std::string const group = "Window";
  parser->add_flag("--watch", options.watch, "Read the scene again when its file is saved")->group(group);
  add_value(*parser, "--size", render.size, parse_size, "WxH", "Of the window, in pixels (default: the scene's)",
            group);
  add_value(*parser, "--camera", render.camera, parse_name, "NAME", "Begin with this camera: name or number", group);
  add_value(*parser, "--root", render.root, parse_name, "NAME", "Show this shape and what is below it only", group);
  add_value(*parser, "--depth", render.depth, parse_depth, "N", "Mirrors and glass in a row (default: 5)", group);
  add_value(*parser, "--device", render.device, parse_name, "NAME",
            "Index, part of a name, cpu, gpu or reference\n(default: the best)", group);
  add_language_options(*parser, render.load.language);
  add_model_options(*parser, render.load.model);
  add_verbosity(*parser, console);
  if (!parse(*parser, arguments)) return false;
  if (options.scene == "-") throw Error(ErrorKind::usage, "a window needs a file, not standard input");
  return true;
}

int view_command(Arguments const& arguments, Console& console) {
  ViewOptions options;
  if (!parse_view(arguments, options, console)) return 0;
  std::string const program = window_program().string();
  std::vector<char*> words{const_cast<char*>(program.c_str())};
  for (std::string const& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
  words.push_back(nullptr);
  ::execv(program.c_str(), words.data());
  if (errno == ENOENT) {
    throw Error(ErrorKind::unavailable,
                "the window was left out of this build: it needs libglfw3-dev, libgl-dev and libimgui-dev (lichtraum "
                "preview shows a scene in the terminal)");
  }
  throw Error(ErrorKind::unavailable, fmt::format("cannot start '{}': {}", program, std::strerror(errno)));
}

}  // namespace lichtraum::app
