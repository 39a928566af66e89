#include "app/render_options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <span>
#include <system_error>

#include "app/arguments.hpp"
#include "lichtraum/words.hpp"

namespace lichtraum::app {
namespace {

/// `--ground glossy`: the word counts as a scene, so that `--ground scene.sdf` draws one.
void refuse_grounds(std::vector<std::string> const& scenes) {
  std::span<Word<Ground> const> const grounds(ground_words);
  for (std::string const& scene : scenes) {
    std::error_code ignored;
    if (!find_value(grounds, scene) || std::filesystem::exists(scene, ignored)) continue;
    throw Error(ErrorKind::usage, fmt::format("there is no scene '{0}': a ground is chosen by --ground={0}", scene));
  }
}

}  // namespace

void add_viewpoint_options(CLI::App& parser, RenderOptions& options, std::string const& group) {
  add_value(parser, "--camera", options.job.camera, parse_name, "NAME",
            "Look through this camera: name, or number from 0", group);
  JobView& view = options.job.view;
  add_value(parser, "--eye", view.eye, parse_point, "X,Y,Z", "Put the camera there", group);
  add_value(parser, "--look-at", view.look_at, parse_point, "X,Y,Z",
            "Point it there (default, if the camera is moved:\nthe middle of what is in view)", group);
  add_value(parser, "--up", view.up, parse_point, "X,Y,Z",
            "Which way is up: of the camera, of --orbit, of a\nmodel's environment and --ground, and of what a\nwindow "
            "turns (default: 0,1,0; of STL files: 0,0,1)",
            group);
  add_value(parser, "--orbit", view.orbit, parse_orbit, "A,E[,D]",
            "Put it at azimuth A to the right of the front\n(+z), elevation E, in degrees; at distance D, or\nwhere it "
            "sees everything",
            group);
  add_value(parser, "--fov-x", view.fov_x_degrees, parse_fov, "DEG", "The camera's horizontal field of view", group);
  add_value(parser, "--fov-y", view.fov_y_degrees, parse_fov, "DEG", "The camera's vertical field of view", group);
  parser
      .add_flag("--orthographic", view.orthographic,
                "Parallel rays: nothing looks smaller for being\nfar away, as in a plan")
      ->group(group);
  add_value(parser, "--aperture", view.aperture, parse_aperture, "D",
            "Diameter of its lens, which blurs what is out of\nfocus (default: 0, all is sharp)", group);
  add_value(parser, "--focus", view.focus, parse_focus, "D|X,Y,Z",
            "Distance of what is sharp, or a point there\n(default: what is looked at)", group);
  add_value(parser, "--root", options.job.root, parse_name, "NAME", "Draw only this shape and what is below it", group);
}

void add_device_option(CLI::App& parser, RenderOptions& options, std::string const& group) {
  add_value(parser, "--device", options.device, parse_name, "NAME",
            "Index, part of a name, cpu, gpu or reference\n(default: the best)", group);
}

void add_environment_options(CLI::App& parser, EnvironmentChoice& environment) {
  std::string const group = "Environment";
  add_value(
      parser, "--environment", environment.source, parse_name, "FILE|studio|none",
      "Light from all around: a .hdr, .exr or .pfm map\nin latitude and longitude, or the built-in studio\n(default: "
      "the scene's)",
      group);
  add_value(parser, "--environment-rotation", environment.rotation_degrees, parse_environment_rotation, "DEG",
            "Turn it counter-clockwise, seen from above", group);
  add_value(parser, "--environment-brightness", environment.brightness, parse_environment_brightness, "X",
            "Multiply its light by this", group);
}

void add_denoise_option(CLI::App& parser, Denoising& denoising) {
  add_value(parser, "--denoise", denoising, parse_denoising, "NAME",
            "Take out noise: auto (default: where there is\nsome), on, off, or builtin (not by Open Image\nDenoise)",
            "Quality");
}

void add_quality_options(CLI::App& parser, RenderOptions& options, std::string const& default_samples) {
  std::string const group = "Quality";
  add_value(parser, "--integrator", options.job.integrator, parse_integrator, "NAME",
            "whitted: direct light, mirrors and glass;\npath: all light (default: what the scene asks for;\npath for "
            "models and for light that only it shows)",
            group);
  add_value(parser, "--samples", options.job.sampling, parse_samples, "N|NxN",
            "Samples per pixel: 16 random ones, or a grid such\nas 4x4 (default: " + default_samples + ")", group);
  add_value(parser, "--depth", options.job.max_depth, parse_depth, "N",
            "Maximum depth of reflection and refraction\n(default: 5; path: 64)", group);
  add_value(parser, "--clamp", options.job.max_indirect, parse_clamp, "X",
            "The most radiance that scattered light may add at\neach bounce, such as 10: less noise, but darker\n"
            "than it should be (default: no limit)",
            group);
  add_value(parser, "--seed", options.job.seed, parse_seed, "N", "Seed of the random samples (default: 0)", group);
  add_value(parser, "--background", options.job.background, parse_background, "COLOR",
            "Radiance where nothing is hit: R,G,B (linear; the\ntone map applies) or '#rrggbb' (sRGB), two of\n"
            "these (top,bottom), environment, or none for\ntransparent (default: the scene's)",
            group);
  add_flag_or_value(parser, "--ground", options.job.ground, parse_ground,
                    "Stand the scene on a ground that shows its\nshadows; --ground=glossy mirrors it, too", group);
  add_value(parser, "--exposure", options.job.exposure_ev, parse_exposure, "EV",
            "Stops brighter, or darker (default: 0)", group);
  add_value(parser, "--tonemap", options.job.tone_map, parse_tone_map, "NAME",
            "auto (default: neutral for models by path and for\nscenes with --environment, else what the "
            "scene's\nlights need), neutral, agx, "
            "aces,\nreinhard or none",
            group);
  add_value(parser, "--transfer", options.job.transfer, parse_transfer, "NAME",
            "linear (default for scenes) or srgb (for models\nand scenes with --environment)", group);
  add_device_option(parser, options, group);
  add_value(parser, "--traversal", options.traversal, parse_traversal, "NAME",
            "How rays find what they hit: auto (default),\nscalar, wide or packet. Only edges may differ", group);
}

void add_picture_options(CLI::App& parser, RenderOptions& options) {
  std::string const group = "Picture";
  add_value(parser, "--size", options.job.size, parse_size, "WxH",
            "Pixels, such as 1280x720 (default: the scene's,\nelse 640x480)", group);
  add_value(parser, "--region", options.job.region, parse_region, "X,Y,W,H", "Draw and write only this part", group);
  add_viewpoint_options(parser, options, group);
  add_value(parser, "--planes", options.job.planes, parse_planes, "LIST",
            "What to store for each pixel, separated by commas:\nradiance (default), alpha, depth, normal, albedo,\n"
            "position, object, instance, material; .exr takes\nseveral, others show one",
            group);
}

void add_drawing_options(CLI::App& parser, RenderOptions& options) {
  add_environment_options(parser, options.job.reading.environment);
  add_quality_options(parser, options);
  add_value(parser, "--noise", options.job.noise, parse_noise, "X",
            "Stop once the noise is below this share of the\nbrightness, such as 0.05; --samples is then the\nmaximum "
            "(default: 4096)",
            "Quality");
  add_denoise_option(parser, options.job.denoising);
  add_language_options(parser, options.job.reading);
  add_model_options(parser, options.job.reading.model);
}

void check_inputs(RenderOptions& options) {
  if (options.job.ground != Ground::none) refuse_grounds(options.scenes);
  options.output.allowed_paths = options.job.reading.allowed_paths;
  options.load.models = make_model_cache();
  options.load.environments = std::make_shared<EnvironmentMaps>();
  if (std::count(options.scenes.begin(), options.scenes.end(), "-") > 1) {
    throw Error(ErrorKind::usage, "standard input (-) is named more than once");
  }
  check_input_format(options.input_format, options.scenes);
}

}  // namespace lichtraum::app
