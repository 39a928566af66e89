#include <CLI/CLI.hpp>

#include "app/arguments.hpp"
#include "app/commands.hpp"
#include "app/file_uri.hpp"
#include "app/files_read.hpp"
#include "app/quick_look.hpp"
#include "app/thumbnail_limits.hpp"

namespace lichtraum::app {
namespace {

constexpr char const* thumbnail_description =
    "Draws one small picture of a scene or a model, for file managers: quickly, the\n"
    "first of several, within 20 s and 4 GiB of memory. INPUT is a file or a\n"
    "file:// URI. OUTPUT becomes a PNG, whatever its extension, whole or not at all.\n"
    "Nothing but errors is printed.";

constexpr char const* thumbnail_examples =
    "  lichtraum thumbnail hello.sdf hello-small.png\n"
    "  lichtraum thumbnail --size 512 model.glb model-large.png\n";

/// Light that is scattered more often hardly shows in a small picture.
constexpr int max_depth = 8;

struct ThumbnailOptions {
  RenderOptions render;
  std::string output;
  int side = 256;  // pixels
};

bool parse_thumbnail(Arguments const& arguments, ThumbnailOptions& options, Console& console) {
  std::vector<std::string> files;
  auto const parser = make_parser("thumbnail", thumbnail_description, thumbnail_examples);
  add_inputs(*parser, files, "INPUT OUTPUT.png");
  std::string const group = "Picture";
  add_value(*parser, "--size", options.side, parse_thumbnail_side, "N", "Pixels of its longer side (default: 256)",
            group);
  add_device_option(*parser, options.render, group);
  add_verbosity(*parser, console);
  console.set_verbosity(Verbosity::quiet);
  if (!parse(*parser, arguments)) return false;
  if (files.size() != 2) {
    throw Error(ErrorKind::usage, "expected two files, INPUT and OUTPUT.png (lichtraum thumbnail --help shows how)");
  }
  options.render.scenes = {path_of(files[0])};
  options.render.job.max_depth = max_depth;
  options.output = files[1];
  return true;
}

}  // namespace

int thumbnail_command(Arguments const& arguments, Console& console) {
  ThumbnailOptions options;
  if (!parse_thumbnail(arguments, options, console)) return 0;
  limit_thumbnail();
  FilesRead files;
  files.add(options.render.scenes.front());
  files.refuse_to_overwrite(options.output);
  check_writable(options.output);
  QuickLook const look(options.render, console);
  Image const image = look.draw(fitted(look.size(), options.side, options.side));
  write_file_atomically(options.output, image_format_named("png").encode(image, {}));
  return 0;
}

}  // namespace lichtraum::app
