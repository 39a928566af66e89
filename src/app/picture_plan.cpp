#include "app/picture_plan.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/picture_bands.hpp"
#include "app/video.hpp"
#include "core/counted.hpp"
#include "core/memory.hpp"

namespace lichtraum::app {
namespace {

std::string list_planes(PlaneSet const& planes) {
  std::string list;
  for (FilmPlane const plane : planes.list()) list += fmt::format("{}{}", list.empty() ? "" : ",", info_of(plane).name);
  return list;
}

void check_planes(Job const& job, Output const& output) {
  ImageFormat const& format = *output.format;
  PlaneSet const planes = shown_planes(job);
  std::size_t const count = planes.list().size();
  bool const is_with_alpha = planes == PlaneSet{FilmPlane::radiance, FilmPlane::alpha};
  if (count <= format.max_planes || (is_with_alpha && format.has_alpha && !output.is_film)) return;
  throw Error(ErrorKind::usage,
              is_with_alpha ? fmt::format("'{}' cannot be transparent: .png and .exr pictures can", output.shown)
                            : fmt::format("--planes {}: '{}' has room for one; .exr has for all", list_planes(planes),
                                          output.shown));
}

void check_encoding(Job const& job, Output const& output) {
  ImageFormat const& format = *output.format;
  Region const& region = *job.region;
  if (job.encoding.bits > format.max_bits) {
    throw Error(ErrorKind::usage, fmt::format("--bits {}: '{}' has {} bits per channel; .png and .ppm have 16",
                                              job.encoding.bits, output.shown, format.max_bits));
  }
  if (std::max(region.width, region.height) > format.max_side) {
    throw Error(ErrorKind::usage, fmt::format("'{}': a {} has at most {} pixels per side, not {}x{}", output.shown,
                                              format.name, format.max_side, region.width, region.height));
  }
}

/// How often a film of these samples has each value of a plane, as Film::of_samples does.
int copies_in_film(PlaneRule rule, SampleRange const& samples) {
  if (rule != PlaneRule::mean) return 1;
  int const blocks = (samples.count() - 1) / Film::block_size + 1;
  return samples.first == 0 ? std::min(blocks, 2) : blocks;
}

/// Of a film, and of one more copy of its values, which are encoded or come from the device.
double drawing_bytes(Region const& region, PlaneSet const& planes, SampleRange const& samples) {
  double pixel_bytes = 0;
  for (FilmPlane const plane : planes.list()) {
    PlaneInfo const& info = info_of(plane);
    pixel_bytes += 4.0 * double(info.channels.size()) * (copies_in_film(info.rule, samples) + 1);
  }
  return pixel_bytes * region.width * region.height;
}

/// Of the units of a picture, some may have later samples than the first.
void check_unit_memory(Region const& picture, PlaneSet const& planes, int sample_count, UnitSize const& unit) {
  Region const region{0, 0, std::min(picture.width, unit.tile.width), std::min(picture.height, unit.tile.height)};
  int const samples = unit.samples > 0 ? std::min(unit.samples, sample_count) : sample_count;
  SampleRange const first{0, samples}, later{samples, std::min(2 * samples, sample_count)};
  double needed = drawing_bytes(region, planes, first);
  if (later.count() > 0) needed = std::max(needed, drawing_bytes(region, planes, later));
  double const available = double(usable_memory_bytes());
  if (needed <= available) return;
  throw Error(ErrorKind::usage,
              fmt::format("a unit of {}x{} pixels and {} needs {} of memory; {} can be used: a smaller --tile "
                          "needs less{}",
                          region.width, region.height, counted(std::uint64_t(samples), "sample"), bytes_text(needed),
                          bytes_text(available),
                          later.count() > Film::block_size ? ", and so do fewer --samples-per-unit" : ""));
}

/// `command`: what the scene says about the picture.
PicturePlan plan_picture(LoadedScene const& script, RenderCommand const& command, Job job, OutputNames& names,
                         bool is_one_of_many, RenderOptions const& options) {
  Scene const& scene = script.scene();
  PicturePlan plan;
  IntegratorChoice const choice = chosen_integrator(job, scene, options.load.device);
  bool const is_size_asked = job.size.has_value();
  job.integrator = choice.integrator;
  plan.integrator_reason = choice.reason;
  plan.job = resolved(std::move(job), scene);
  plan.output = names.next(command, is_one_of_many);
  // What stores planes stores them as they were traced; other planes have no noise.
  bool const may_be_developed = plan.output.format->encode || options.unit;
  bool const is_developed = may_be_developed && plan.job.planes.has(FilmPlane::radiance);
  if (!is_developed) plan.job.denoising = Denoising::off;
  if (options.unit) {
    check_unit_memory(*plan.job.region, traced_planes(plan.job), plan.job.sampling->count, *options.unit);
    return plan;
  }
  bool const is_denoised = plan.job.denoising != Denoising::off;
  check_memory(bands_of(plan, is_denoised).front(), traced_planes(plan.job), plan.job.sampling->count,
               is_size_asked ? ErrorKind::usage : ErrorKind::scene, is_denoised);
  check_format(plan.job, plan.output);
  if (!plan.output.is_standard_output()) {
    script.files().refuse_to_overwrite(plan.output.path);
    script.files().refuse_to_overwrite(plan.output.partial_path());
    check_writable(plan.output.path);
  }
  return plan;
}

}  // namespace

void check_format(Job const& job, Output const& output) {
  check_encoding(job, output);
  check_planes(job, output);
  if (output.is_film) check_film(output.path, {job.region->width, job.region->height});
}

void check_memory(Region const& region, PlaneSet const& planes, int sample_count, ErrorKind kind, bool is_denoised) {
  constexpr double denoising_bytes = 120;  // of a pixel: what it is given, and the built-in filter's planes
  double needed = drawing_bytes(region, planes, {0, sample_count});
  if (is_denoised) needed += denoising_bytes * region.width * region.height;
  double const available = double(usable_memory_bytes());
  if (needed <= available) return;
  throw Error(kind, fmt::format("a picture of {}x{} pixels needs {} of memory; {} can be used: a "
                                "smaller size needs less, and --region draws a part of it",
                                region.width, region.height, bytes_text(needed), bytes_text(available)));
}

std::vector<PicturePlan> plan_pictures(LoadedScene const& script, SceneSource const& source,
                                       RenderOptions const& options, OutputNames& names) {
  Scene const& scene = script.scene();
  std::vector<RenderCommand> commands = scene.renders;
  if (commands.empty()) {
    RenderCommand command;
    command.file = scene.filename.empty() ? names.stem_of(source) + ".png" : scene.filename;
    command.location.file = source.name();
    commands.push_back(command);
  }
  std::vector<double> const& times = script.times_seconds();
  std::size_t const scene_count = times.empty() ? commands.size() : times.size();
  int const turns = std::max(1, options.turntable);
  std::size_t const picture_count = scene_count * std::size_t(turns);
  names.begin_scene(picture_count);
  if (picture_count > 1 && names.has_one_name()) {
    throw Error(ErrorKind::usage,
                fmt::format("{} draws {} pictures, and --output names one file: write a number into the name, such as "
                            "-o picture-%04d.png, or make a film, -o film.mp4",
                            source.name(), picture_count));
  }
  std::vector<PicturePlan> plans;
  for (std::size_t scene_number = 0; scene_number < scene_count; ++scene_number) {
    RenderCommand const& command = commands[times.empty() ? scene_number : 0];
    Job job = source.job(options.job);
    if (times.empty()) {
      job.picture = int(scene_number);
    } else {
      job.reading.model.time_seconds = times[scene_number];
    }
    for (int turn = 0; turn < turns; ++turn) {
      if (options.turntable > 0) job.turn_degrees = 360.0 * turn / turns;
      bool const is_one_of_many = options.turntable > 0 || options.frames || times.size() > 1;
      plans.push_back(plan_picture(script, command, job, names, is_one_of_many, options));
      plans.back().scene_number = scene_number;
      plans.back().location = command.location;
    }
  }
  return plans;
}

RenderRequest request_for(PicturePlan const& plan, Scene const& scene, std::optional<Vec3>& turn_center) {
  if (!plan.job.camera.empty() && !scene.cameras.contains(plan.job.camera)) {
    throw Error(ErrorKind::usage, fmt::format("{}: the camera '{}' is defined after the picture '{}' is drawn",
                                              plan.job.scene, plan.job.camera, plan.output.shown));
  }
  if (plan.job.turn_degrees && !turn_center) {
    Job still = plan.job;
    still.turn_degrees.reset();
    turn_center = turn_center_of(still, scene, request_of(still, scene).camera);
  }
  return request_of(plan.job, scene, turn_center);
}

}  // namespace lichtraum::app
