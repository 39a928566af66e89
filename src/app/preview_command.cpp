#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "app/arguments.hpp"
#include "app/commands.hpp"
#include "app/interruption.hpp"
#include "app/quick_look.hpp"
#include "app/terminal.hpp"
#include "app/values.hpp"

namespace lichtraum::app {
namespace {

constexpr char const* preview_description =
    "Shows a scene in the terminal: in the terminal's own graphics (kitty's or\n"
    "sixel) where it has them, else as characters in two colours. SCENE is an eSDF\n"
    "file, a model, or - for standard input.";

constexpr char const* preview_examples =
    "  lichtraum preview hello.sdf\n"
    "  lichtraum preview model.glb --time 1.5\n"
    "  lichtraum preview hello.sdf --size 60x20 --graphics blocks > hello.txt\n";

/// A terminal that says nothing: what people have on slow lines answers within this.
constexpr std::chrono::milliseconds patience{300};

struct PreviewOptions {
  RenderOptions render;  // its size is that of the area, in characters
  std::optional<TerminalGraphics> graphics;
};

std::optional<TerminalGraphics> parse_graphics(std::string_view text) {
  if (text == "auto") return std::nullopt;
  if (text == "blocks") return TerminalGraphics::blocks;
  if (text == "kitty") return TerminalGraphics::kitty;
  if (text == "sixel") return TerminalGraphics::sixel;
  throw std::invalid_argument("expected auto, blocks, kitty or sixel");
}

bool parse_preview(Arguments const& arguments, PreviewOptions& options, Console& console) {
  RenderOptions& render = options.render;
  std::string scene;
  auto const parser = make_parser("preview", preview_description, preview_examples);
  add_inputs(*parser, scene, "SCENE");
  std::string const group = "Picture";
  add_value(*parser, "--size", render.job.size, parse_size, "CxR",
            "Columns and rows of characters at most\n(default: the terminal's)", group);
  add_value(*parser, "--graphics", options.graphics, parse_graphics, "NAME",
            "auto (default: ask the terminal), blocks, kitty\nor sixel", group);
  add_viewpoint_options(*parser, render, group);
  add_value(*parser, "--samples", render.job.sampling, parse_samples, "N|NxN",
            "Samples per pixel (default: 3x3; path: 16)", group);
  add_device_option(*parser, render, group);
  add_language_options(*parser, render.job.reading);
  add_model_options(*parser, render.job.reading.model);
  add_input_format_option(*parser, render.input_format);
  add_verbosity(*parser, console);
  if (!parse(*parser, arguments)) return false;
  render.scenes = {scene};
  check_input_format(render.input_format, render.scenes);
  return true;
}

/// As large as fits into the area with the picture's proportions, leaving a row for the shell's next line.
Resolution fit(Resolution const& picture, TerminalSize const& area, TerminalGraphics graphics) {
  bool const is_blocks = graphics == TerminalGraphics::blocks;
  double const width = area.columns * (is_blocks ? 1.0 : area.cell_width);
  double const height = std::max(1, area.rows - 1) * (is_blocks ? 2.0 : area.cell_height);
  return fitted(picture, width, height);
}

std::string encode(Image const& image, TerminalGraphics graphics) {
  switch (graphics) {
    case TerminalGraphics::blocks:
      return encode_blocks(image);
    case TerminalGraphics::kitty:
      return encode_kitty(image);
    case TerminalGraphics::sixel:
      return encode_sixel(image);
  }
  return {};
}

}  // namespace

int preview_command(Arguments const& arguments, Console& console) {
  PreviewOptions options;
  if (!parse_preview(arguments, options, console)) return 0;
  RenderOptions& render = options.render;
  auto const terminal = terminal_size();
  TerminalSize area = terminal.value_or(TerminalSize());
  if (render.job.size) {
    area.columns = render.job.size->width;
    area.rows = render.job.size->height + 1;
    render.job.size.reset();
  }
  constexpr int most_characters = 10'000;
  if (area.columns > most_characters || area.rows > most_characters) {
    throw Error(ErrorKind::usage, fmt::format("--size: at most {0}x{0} characters", most_characters));
  }

  QuickLook const look(render, console);
  // A pipe or a file cannot be asked: blocks are text, and every terminal that it is shown in later knows them.
  TerminalGraphics const graphics = options.graphics ? *options.graphics
                                    : terminal       ? ask_for_graphics(patience)
                                                     : TerminalGraphics::blocks;
  if (interrupted()) throw Error(ErrorKind::interrupted, "interrupted");
  Image const image = look.draw(fit(look.size(), area, graphics));
  write_standard_output(encode(image, graphics));
  return 0;
}

}  // namespace lichtraum::app
