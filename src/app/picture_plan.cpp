#include "app/picture_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <iterator>

#include "app/arguments.hpp"
#include "core/memory.hpp"

namespace lichtraum::app {
namespace {

constexpr Resolution default_resolution{640, 480};
constexpr int default_depth = 5;

std::string human(double bytes) {
  for (char const* const unit : {"bytes", "kB", "MB", "GB", "TB", "PB"}) {
    if (bytes < 1000) return fmt::format("{:.3g} {}", bytes, unit);
    bytes /= 1000;
  }
  return fmt::format("{:.3g} EB", bytes);
}

std::string list_cameras(Scene const& scene) {
  std::string list;
  for (Camera const& camera : scene.cameras) list += fmt::format("{}{}", list.empty() ? "" : ", ", camera.name());
  return list;
}

Camera const& find_camera(Scene const& scene, SceneSource const& source, RenderOptions const& options,
                          std::string const& name_in_scene) {
  if (scene.cameras.empty()) {
    throw Error(ErrorKind::scene, fmt::format("{}: there is no camera, so nothing can be drawn; 'define camera eye 45' "
                                              "puts one at the origin that looks along -z",
                                              source.name()));
  }
  std::string const& name = options.camera.empty() ? name_in_scene : options.camera;
  if (name.empty()) return scene.cameras.front();
  if (Camera const* const camera = scene.cameras.find(name)) return *camera;
  std::size_t number = 0;
  auto const [end, error] = std::from_chars(name.data(), name.data() + name.size(), number);
  bool const is_number = error == std::errc() && end == name.data() + name.size();
  if (!options.camera.empty() && is_number && number < scene.cameras.size()) {
    return *std::next(scene.cameras.begin(), std::ptrdiff_t(number));
  }
  throw Error(options.camera.empty() ? ErrorKind::scene : ErrorKind::usage,
              fmt::format("{}: there is no camera '{}'; there are: {}", source.name(), name, list_cameras(scene)));
}

Resolution choose_size(Scene const& scene, Camera const& camera, RenderCommand const& command,
                       RenderOptions const& options) {
  if (options.size) return *options.size;
  if (command.resolution) return *command.resolution;
  if (camera.resolution()) return *camera.resolution();
  return scene.resolution.value_or(default_resolution);
}

Sampling choose_sampling(RenderCommand const& command, RenderOptions const& options) {
  if (options.sampling) return *options.sampling;
  int const count = command.samples.value_or(1);
  return {count == 1 ? Sampling::Pattern::grid : Sampling::Pattern::seeded, count};
}

Region choose_region(Resolution const& size, RenderOptions const& options) {
  if (!options.region) return whole_picture(size);
  Region const& r = *options.region;
  if (r.x > size.width - r.width || r.y > size.height - r.height) {
    throw Error(ErrorKind::usage, fmt::format("--region: {},{},{},{} does not lie in the picture of {}x{} pixels", r.x,
                                              r.y, r.width, r.height, size.width, size.height));
  }
  return r;
}

std::string list_planes(PlaneSet const& planes) {
  std::string list;
  for (FilmPlane const plane : planes.list()) list += fmt::format("{}{}", list.empty() ? "" : ",", info_of(plane).name);
  return list;
}

void check_planes(PicturePlan const& plan) {
  ImageFormat const& format = *plan.output.format;
  std::size_t const count = plan.planes.list().size();
  bool const is_with_alpha = plan.planes == PlaneSet{FilmPlane::radiance, FilmPlane::alpha};
  if (count <= format.max_planes || (is_with_alpha && format.has_alpha && !plan.output.is_film)) return;
  throw Error(ErrorKind::usage,
              is_with_alpha ? fmt::format("'{}' cannot be transparent: .png and .exr pictures can", plan.output.shown)
                            : fmt::format("--planes {}: '{}' has room for one; .exr has for all",
                                          list_planes(plan.planes), plan.output.shown));
}

void check_encoding(PicturePlan const& plan) {
  ImageFormat const& format = *plan.output.format;
  if (plan.encoding.bits > format.max_bits) {
    throw Error(ErrorKind::usage, fmt::format("--bits {}: '{}' has {} bits per channel; .png and .ppm have 16",
                                              plan.encoding.bits, plan.output.shown, format.max_bits));
  }
  if (std::max(plan.region.width, plan.region.height) > format.max_side) {
    throw Error(ErrorKind::usage, fmt::format("'{}': a {} has at most {} pixels per side, not {}x{}", plan.output.shown,
                                              format.name, format.max_side, plan.region.width, plan.region.height));
  }
}

PicturePlan plan_picture(Scene const& scene, SceneSource const& source, RenderCommand const& command,
                         RenderOptions const& options, OutputNames& names, bool is_one_of_many) {
  Camera const& camera = find_camera(scene, source, options, command.camera);
  PicturePlan plan;
  plan.camera = camera.name();
  plan.size = choose_size(scene, camera, command, options);
  plan.region = choose_region(plan.size, options);
  plan.sampling = choose_sampling(command, options);
  plan.planes = options.wanted_planes();
  check_memory(plan.region, plan.planes, plan.sampling.count, options.size ? ErrorKind::usage : ErrorKind::scene);
  plan.depth = options.depth.value_or(command.depth.value_or(default_depth));
  plan.output = names.next(command.file, is_one_of_many);
  plan.encoding = options.encoding;
  check_encoding(plan);
  check_planes(plan);
  if (!plan.output.is_standard_output() && !plan.output.is_film) check_writable(plan.output.path);
  return plan;
}

}  // namespace

RenderRequest first_view(LoadedScene const& loaded, SceneSource const& source, RenderOptions const& options) {
  Scene const& scene = loaded.scene();
  RenderCommand const command = scene.renders.empty() ? RenderCommand() : scene.renders.front();
  RenderRequest request;
  request.camera = find_camera(scene, source, options, command.camera);
  request.resolution = choose_size(scene, request.camera, command, options);
  request.region = whole_picture(request.resolution);
  request.sampling = options.sampling.value_or(Sampling());
  request.max_depth = options.depth.value_or(command.depth.value_or(default_depth));
  request.seed = options.seed;
  if (options.background) request.background = options.background->color.value_or(Rgb(0));
  return request;
}

Development choose_development(Scene const& scene, bool is_model, RenderOptions const& options) {
  return {options.exposure_ev, options.tone_map == ToneMap::automatic ? scene.tone_map : options.tone_map,
          options.transfer.value_or(is_model ? Transfer::srgb : Transfer::linear)};
}

void check_memory(Region const& region, PlaneSet const& planes, int sample_count, ErrorKind kind) {
  double pixel_bytes = 0;
  for (FilmPlane const plane : planes.list()) {
    bool const has_blocks = info_of(plane).rule == PlaneRule::mean && sample_count > Film::block_size;
    // As much again while it is encoded.
    pixel_bytes += 4.0 * double(info_of(plane).channels.size()) * (has_blocks ? 3 : 2);
  }
  double const needed = pixel_bytes * region.width * region.height;
  double const available = double(usable_memory_bytes());
  if (needed <= available) return;
  throw Error(kind, fmt::format("a picture of {}x{} pixels needs {} of memory; {} can be used. --region draws a "
                                "part of it",
                                region.width, region.height, human(needed), human(available)));
}

std::vector<PicturePlan> plan_pictures(LoadedScene const& script, SceneSource const& source,
                                       RenderOptions const& options, OutputNames& names) {
  Scene const& scene = script.scene();
  std::vector<RenderCommand> commands = scene.renders;
  if (commands.empty()) {
    RenderCommand command;
    command.file = scene.filename.empty() ? source.stem() + ".png" : scene.filename;
    commands.push_back(command);
  }
  std::vector<double> const& times = script.times_seconds();
  std::size_t const scene_count = times.empty() ? commands.size() : times.size();
  int const turns = std::max(1, options.turntable);
  std::size_t const picture_count = scene_count * std::size_t(turns);
  if (picture_count > 1 && names.has_one_name()) {
    throw Error(ErrorKind::usage,
                fmt::format("{} draws {} pictures, and --output names one file: write a number into the name, such as "
                            "-o picture-%04d.png, or make a film, -o film.mp4",
                            source.name(), picture_count));
  }
  std::vector<PicturePlan> plans;
  for (std::size_t scene_number = 0; scene_number < scene_count; ++scene_number) {
    RenderCommand const& command = commands[times.empty() ? scene_number : 0];
    for (int turn = 0; turn < turns; ++turn) {
      bool const is_one_of_many = turns > 1 || times.size() > 1;
      PicturePlan plan = plan_picture(scene, source, command, options, names, is_one_of_many);
      plan.scene_number = scene_number;
      if (!times.empty()) plan.time_seconds = times[scene_number];
      plan.turn_degrees = 360.0 * turn / turns;
      plans.push_back(std::move(plan));
    }
  }
  return plans;
}

}  // namespace lichtraum::app
