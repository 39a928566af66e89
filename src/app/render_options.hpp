#pragma once

#include <CLI/App.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/loaded_scene.hpp"
#include "app/output_names.hpp"
#include "app/values.hpp"
#include "lichtraum/renderer.hpp"

namespace lichtraum::app {

/// The largest part of a picture that one machine draws at once.
struct UnitSize {
  Resolution tile;
  int samples = 0;  ///< of a pixel; 0: all
};

/// What `lichtraum render` is asked for: what its pictures have in common, and what concerns the program alone.
struct RenderOptions {
  std::vector<std::string> scenes;
  std::string input_format;  // of standard input; empty: as its bytes tell
  Job job;                   // without its scene
  LoadOptions load;

  OutputOptions output;
  bool has_bits = false;  // given on the command line, not the default
  bool has_quality = false;

  std::string device;
  std::optional<Traversal> traversal;

  std::optional<FrameRange> frames;  // of a model's animation
  std::optional<double> frames_per_second;
  int turntable = 0;  // pictures around the scene; 0: as the camera stands
  bool resume = false;
  /// Of plans for several machines: what is drawn at once. What format the pictures will have is not known then.
  /// Nothing: each is drawn whole.
  std::optional<UnitSize> unit;
  bool is_merging = false;  // the pictures come from units: nothing else can be traced

  bool show = false;  // in a window, afterwards
  bool json = false;

  double frame_rate() const { return frames_per_second.value_or(default_frame_rate); }
  static constexpr double default_frame_rate = 25;
};

/// --camera, --eye, --look-at, --up, --orbit, --fov-x, --fov-y and --root.
void add_viewpoint_options(CLI::App& parser, RenderOptions& options, std::string const& group);
/// --device.
void add_device_option(CLI::App& parser, RenderOptions& options, std::string const& group);
/// --environment, --environment-rotation and --environment-brightness.
void add_environment_options(CLI::App& parser, EnvironmentChoice& environment);
/// --denoise.
void add_denoise_option(CLI::App& parser, Denoising& denoising);
/// --integrator, --samples, --depth, --clamp, --seed, --background, --ground, --exposure, --tonemap, --transfer,
/// --device and --traversal. `default_samples`: for the help.
void add_quality_options(CLI::App& parser, RenderOptions& options,
                         std::string const& default_samples = "1; 64 with a lens or by path;\n16 for models");

/// What part of a picture is drawn, and of each pixel: --size, --region, --planes, and the viewpoint's.
void add_picture_options(CLI::App& parser, RenderOptions& options);
/// What else decides a picture of `render`: light, quality, how scenes and models are read.
void add_drawing_options(CLI::App& parser, RenderOptions& options);
/// --output, --format, --output-dir and the encoding's.
void add_file_options(CLI::App& parser, RenderOptions& options, std::string const& group);
/// --bits, --quality and --ppm-ascii.
void add_encoding_options(CLI::App& parser, RenderOptions& options, std::string const& group);
/// --frames, --fps and --turntable.
void add_sequence_options(CLI::App& parser, RenderOptions& options);

/// What the options say together; throws Error{usage} where they contradict each other.
void combine(RenderOptions& options, std::vector<std::string> const& inputs, OutputNames& names);

/// What the scenes of a parsed command line have in common. Throws Error{usage} for what cannot be read.
void check_inputs(RenderOptions& options);

}  // namespace lichtraum::app
