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

/// What `lichtraum render` is asked for. What is not given comes from the scene.
struct RenderOptions {
  std::vector<std::string> scenes;
  LoadOptions load;

  OutputOptions output;
  ImageEncoding encoding;
  bool has_bits = false;  // given on the command line, not the default
  bool has_quality = false;
  bool has_development = false;  // --exposure, --tonemap or --transfer

  std::optional<Resolution> size;
  std::optional<Region> region;
  std::string camera;
  std::string root;
  PlaneSet planes{FilmPlane::radiance};
  struct Background {
    std::optional<Rgb> color;  // nothing: transparent
  };
  std::optional<Background> background;  // else the scene's

  std::optional<Sampling> sampling;
  std::optional<int> depth;
  std::uint64_t seed = 0;
  double exposure_ev = 0;
  ToneMap tone_map = ToneMap::automatic;
  std::optional<Transfer> transfer;  // nothing: srgb for models, linear for scenes
  std::string device;
  std::optional<Traversal> traversal;

  std::optional<FrameRange> frames;  // of a model's animation
  std::optional<double> frames_per_second;
  int turntable = 0;  // pictures around the scene; 0: as the camera stands
  bool resume = false;

  bool show = false;  // in a window, afterwards
  bool json = false;

  /// What is asked for, and what --background none needs besides.
  PlaneSet wanted_planes() const {
    PlaneSet wanted = planes;
    if (background && !background->color && planes.has(FilmPlane::radiance)) wanted.add(FilmPlane::alpha);
    return wanted;
  }
  double frame_rate() const { return frames_per_second.value_or(default_frame_rate); }
  static constexpr double default_frame_rate = 25;
};

/// --camera and --root.
void add_viewpoint_options(CLI::App& parser, RenderOptions& options, std::string const& group);
/// --device.
void add_device_option(CLI::App& parser, RenderOptions& options, std::string const& group);
/// --samples, --depth, --seed, --background, --exposure, --tonemap, --transfer, --device and --traversal.
/// `default_samples`: for the help.
void add_quality_options(CLI::App& parser, RenderOptions& options, std::string const& default_samples);

}  // namespace lichtraum::app
