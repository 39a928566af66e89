#include "app/scene_drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <map>

#include "app/empty_view.hpp"
#include "app/interruption.hpp"
#include "app/progress_bar.hpp"

namespace lichtraum::app {
namespace {

using Clock = std::chrono::steady_clock;

double milliseconds_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

Image crop(Image image, Region const& region) {
  if (image.size() == Resolution{region.width, region.height}) return image;
  Image part(Resolution{region.width, region.height});
  for (int y = 0; y < region.height; ++y) {
    std::copy_n(image.pixel(region.x, region.y + y), 3 * region.width, part.pixel(0, y));
  }
  return part;
}

class SceneDrawing {
 public:
  SceneDrawing(SceneSource const& source, RenderOptions const& options, Renderer& renderer, Console const& console)
      : source_(source), options_(options), renderer_(renderer), console_(console) {}

  void run(OutputNames& names, SceneReport& report) {
    auto const start = Clock::now();
    LoadedScene const script = source_.load(options_.load);
    is_model_ = script.is_model();
    report.load_ms = milliseconds_since(start);
    console_.show(script.diagnostics());
    console_.detail(fmt::format("{}: loaded in {:.1f} ms", source_.name(), report.load_ms));

    std::vector<PicturePlan> const plans = plan_pictures(script, source_, options_, names);
    say_what_was_decided(plans);
    script.play([&](Scene const& scene, std::size_t index) { draw(scene, plans[index], index, report); });
  }

 private:
  void say_what_was_decided(std::vector<PicturePlan> const& plans) const {
    std::map<std::filesystem::path, int> uses;
    for (PicturePlan const& plan : plans) {
      ImageFormat const& format = *plan.output.format;
      int const use = plan.output.is_standard_output() ? 1 : ++uses[plan.output.path];
      if (use == 2) {
        console_.warning(
            fmt::format("several pictures are called '{}': the last one stays (-o picture-%04d.png numbers them)",
                        plan.output.shown));
      }
      if (use > 1) continue;
      if (!plan.output.note.empty()) console_.warning(plan.output.note);
      auto const has_no_effect = [&](bool given, bool applies, char const* option) {
        if (given && !applies) console_.warning(fmt::format("{} has no effect on '{}'", option, plan.output.shown));
      };
      has_no_effect(options_.has_bits, !format.is_linear_float && format.max_bits > 8, "--bits");
      has_no_effect(options_.has_quality, format.name == "jpg", "--quality");
      has_no_effect(options_.encoding.ppm_ascii, format.name == "ppm", "--ppm-ascii");
      has_no_effect(options_.has_development, !format.is_linear_float, "--tonemap and --transfer");
    }
  }

  RenderRequest make_request(Scene const& scene, PicturePlan const& plan) const {
    RenderRequest request;
    Camera const* const camera = scene.cameras.find(plan.camera);
    if (!camera) {
      throw Error(ErrorKind::usage, fmt::format("{}: the camera '{}' is defined after the picture '{}' is drawn",
                                                source_.name(), plan.camera, plan.output.shown));
    }
    request.camera = *camera;
    request.resolution = plan.size;
    request.region = plan.region;
    request.sampling = plan.sampling;
    request.max_depth = plan.depth;
    request.seed = options_.seed;
    if (!plan.output.format->is_linear_float) {
      request.tone_map = options_.tone_map == ToneMap::automatic ? scene.tone_map : options_.tone_map;
      request.transfer = options_.transfer.value_or(is_model_ ? Transfer::srgb : Transfer::linear);
    }
    return request;
  }

  void draw(Scene const& scene, PicturePlan const& plan, std::size_t index, SceneReport& report) {
    PictureReport& picture = report.pictures.emplace_back();
    picture.plan = plan;
    RenderRequest const request = make_request(scene, plan);
    picture.scene = renderer_.set_scene(scene, options_.root);
    if (picture.scene.unrepresentable > 0) {
      console_.warning(
          fmt::format("{}: {} shapes are left out: their coordinates are too large or too small for the device",
                      source_.name(), picture.scene.unrepresentable));
    }

    GracefulScope const graceful;
    Image image(plan.size);
    RenderResult result;
    {
      ProgressBar bar(console_, plan.output.shown);
      result = renderer_.render(request, image, [&](RenderProgress const& progress) {
        bar.update(progress);
        return !interrupted();
      });
    }
    picture.is_complete = result.complete;
    picture.render = result.statistics;
    write(crop(std::move(image), plan.region), picture);
    if (!result.complete) {
      throw Error(ErrorKind::interrupted,
                  picture.written_to.empty() ? "interrupted: nothing was written"
                                             : fmt::format("interrupted: what is done is in '{}'", picture.written_to));
    }

    console_.info(summary(picture));
    console_.detail(details(picture));
    if (result.statistics.rays.camera > 0 && result.statistics.rays.camera_hits == 0 && !options_.region) {
      explain_empty_view(request, index);
    }
    if (interrupted()) throw Error(ErrorKind::interrupted, "interrupted");
  }

  void write(Image const& image, PictureReport& picture) const {
    auto const start = Clock::now();
    Output const& output = picture.plan.output;
    if (!picture.is_complete && output.is_standard_output()) return;  // nobody could tell it from a whole one
    std::string const bytes = output.format->encode(image, picture.plan.encoding);
    if (output.is_standard_output()) {
      write_standard_output(bytes);
      picture.written_to = output.shown;
    } else if (picture.is_complete) {
      write_file_atomically(output.path, bytes);
      picture.written_to = output.shown;
    } else {
      Output shown = output;
      shown.path = output.shown;
      picture.written_to = shown.partial_path().string();
      write_file_atomically(output.partial_path(), bytes);
    }
    picture.write_ms = milliseconds_since(start);
  }

  /// Says where the scene lies, and which other convention would show it. Once a file.
  void explain_empty_view(RenderRequest const& request, std::size_t index) {
    if (has_explained_ || console_.is_quiet()) return;
    has_explained_ = true;
    std::string message =
        fmt::format("{}: the camera '{}' sees nothing: {}", source_.name(), request.camera.name(),
                    describe_direction(request.camera, renderer_.bounds_min(), renderer_.bounds_max()));
    for (Convention const& convention : other_conventions(options_.load.language)) {
      if (is_model_ || !shows_something(convention.options, request, index)) continue;
      message += fmt::format("; with {} it is in view", convention.arguments);
      break;
    }
    console_.warning(message);
  }

  /// Draws the picture again, small, from the file read under other options.
  bool shows_something(EsdfOptions const& language, RenderRequest request, std::size_t wanted) {
    constexpr int probe_width = 64;
    int const height = std::max(1, int(double(request.resolution.height) * probe_width / request.resolution.width));
    request.resolution = {probe_width, std::min(height, 4 * probe_width)};
    request.region = {0, 0, request.resolution.width, request.resolution.height};
    request.sampling = {};
    request.max_depth = 0;
    bool is_seen = false;
    LoadOptions load = options_.load;
    load.language = language;
    LoadedScene const script = source_.load(load);
    script.play([&](Scene const& scene, std::size_t index) {
      Camera const* const camera = scene.cameras.find(request.camera.name());
      if (index != wanted || !camera) return;
      request.camera = *camera;
      renderer_.set_scene(scene, options_.root);
      Image image(request.resolution);
      is_seen = renderer_.render(request, image).statistics.rays.camera_hits > 0;
    });
    return is_seen;
  }

  SceneSource const& source_;
  RenderOptions const& options_;
  Renderer& renderer_;
  Console const& console_;
  bool is_model_ = false;
  bool has_explained_ = false;
};

}  // namespace

void draw_scene(SceneSource const& source, RenderOptions const& options, OutputNames& names, Renderer& renderer,
                Console const& console, SceneReport& report) {
  SceneDrawing(source, options, renderer, console).run(names, report);
}

}  // namespace lichtraum::app
