#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>

#include "app/arguments.hpp"
#include "app/console.hpp"
#include "app/picture_plan.hpp"
#include "app/render_options.hpp"
#include "app/scene_source.hpp"
#include "app/video.hpp"

namespace lichtraum::app {

void add_file_options(CLI::App& parser, RenderOptions& options, std::string const& group) {
  auto const path = [](std::string const& text) { return std::filesystem::path(parse_name(text)); };
  auto const format = [](std::string const& text) { return &image_format_named(text); };
  add_value(parser, "-o,--output", options.output.file, parse_name, "FILE",
            "Write to FILE: a name with .png, .ppm, .jpg,\n.exr or .pfm; %04d numbers pictures; .mp4,\n.webm or .gif "
            "is a film; - is standard output",
            group);
  add_value(parser, "--format", options.output.format, format, "NAME",
            "png, ppm, jpg, exr or pfm, whatever the extension", group);
  add_value(parser, "--output-dir", options.output.folder, path, "FOLDER",
            "Folder for pictures (default: the current one)", group);
  add_encoding_options(parser, options, group);
}

void add_encoding_options(CLI::App& parser, RenderOptions& options, std::string const& group) {
  auto const bits = [&options](std::string const& text) {
    options.has_bits = true;
    return parse_bits(text);
  };
  add_value(parser, "--bits", options.job.encoding.bits, bits, "8|16", "Bits per channel, 16 for .png and .ppm", group);
  auto const quality = [&options](std::string const& text) {
    options.has_quality = true;
    return parse_quality(text);
  };
  add_value(parser, "--quality", options.job.encoding.jpeg_quality, quality, "1-100", "JPEG quality (default: 92)",
            group);
  parser.add_flag("--ppm-ascii", options.job.encoding.ppm_ascii, "Write .ppm as text")->group(group);
}

void add_sequence_options(CLI::App& parser, RenderOptions& options) {
  std::string const group = "Sequences and films";
  add_value(parser, "--frames", options.frames, parse_frames, "A..B",
            "Draw these frames of a model's animation: frame\nN is N / fps seconds from its start", group);
  add_value(parser, "--fps", options.frames_per_second, parse_frame_rate, "N",
            "Frames per second of --frames and of films\n(default: 25)", group);
  add_value(parser, "--turntable", options.turntable, parse_count, "N",
            "Draw N pictures with the camera circling what\nis in view", group);
}

void combine(RenderOptions& options, std::vector<std::string> const& inputs, OutputNames& names) {
  if (inputs.size() > 1 && names.has_one_name()) {
    throw Error(ErrorKind::usage,
                "--output names one file, and there are several scenes: write a number into the name, "
                "such as -o picture-%04d.png, or make a film, -o film.mp4");
  }
  names.set_inputs(inputs);
  if (options.output.file == "-" && is_standard_output_closed()) {
    throw Error(ErrorKind::cannot_create, "cannot write to standard output: it is closed");
  }
  if (options.output.file == "-" && ::isatty(STDOUT_FILENO) == 1) {
    throw Error(
        ErrorKind::usage,
        "--output -: standard output is a terminal, which shows no picture files: lichtraum preview shows scenes "
        "there, > picture.png writes a file");
  }
  if (options.frames) {
    if (options.job.reading.model.time_seconds) throw Error(ErrorKind::usage, "--time and --frames cannot be combined");
    if (options.turntable > 0) throw Error(ErrorKind::usage, "--turntable and --frames cannot be combined");
    bool const may_be_gltf = inputs.size() == 1 && (inputs.front() == "-" || is_gltf_file(inputs.front()));
    if (!may_be_gltf) throw Error(ErrorKind::usage, frames_need_gltf);
    for (int frame = options.frames->first; frame <= options.frames->last; ++frame) {
      options.load.times_seconds.push_back(frame / options.frame_rate());
    }
    names.start_at(options.frames->first);
  } else if (options.frames_per_second && !names.is_film()) {
    throw Error(ErrorKind::usage, "--fps is for films (-o film.mp4; of a plan, give it to job merge) and for --frames");
  } else if (names.is_film() && options.turntable == 0 && !options.job.reading.model.time_seconds) {
    options.load.whole_animation_rate = options.frame_rate();
  }
  if (names.is_film()) {
    check_frame_rate(options.output.file, options.frame_rate());
    if (options.resume) {
      throw Error(ErrorKind::usage, "a film cannot be resumed: --resume goes on with pictures (-o picture-%04d.png)");
    }
    check_ffmpeg();
  }
}

}  // namespace lichtraum::app
