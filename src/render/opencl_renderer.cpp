#include "render/opencl_renderer.hpp"

#include <algorithm>
#include <chrono>
#include <limits>

#include "cl/tile_tracer.hpp"
#include "denoise/noise_planes.hpp"
#include "film/develop.hpp"
#include "film/trace_blocks.hpp"
#include "render/frame_parameters.hpp"
#include "render/tile_plan.hpp"
#include "scene/drawn_roots.hpp"
#include "scene/flatten.hpp"
#include "scene/lowest_point.hpp"
#include "scene/object_numbers.hpp"
#include "scene/scene_content.hpp"
#include "scene/unit_vector.hpp"

namespace lichtraum {
namespace {

using Clock = std::chrono::steady_clock;

/// The device's number of no shape, instance or material; in a film the largest number that there is.
constexpr std::uint32_t nothing = 0xffffffffu;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// A tile should take this long: short enough that a user who interrupts does not wait, long enough that launches
/// (30 microseconds) do not count.
constexpr double tile_seconds = 0.05;
/// Pixels times samples of the first tile, when nothing is known about the scene's cost.
constexpr double first_budget = 1 << 14;
/// One tile's ray counters take 16 bytes a pixel and should stay in the cache.
constexpr double max_budget = 1 << 18;

/// And the least; below, launches would count.
constexpr double min_budget = 64;
/// How many leaves the rays of one tile may test, whatever the tiles before it took: with those of a million triangles
/// in one place, a fifth of a second in packets of rays.
constexpr double max_leaf_tests = 8e7;

/// What a tile is on a GPU, which traces half a million pixels at once: many pixels, and of each what samples there is
/// time for.
constexpr double gpu_launch_pixels = 1 << 19;
constexpr double gpu_max_budget = 1 << 24;

/// The greatest work of a tile in a scene, by its crowding (accel/crowding.hpp).
double greatest_budget(DeviceKind kind, double crowding) {
  double const most = kind == DeviceKind::gpu ? gpu_max_budget : max_budget;
  return std::clamp(max_leaf_tests / std::max(crowding, 1.0), min_budget, most);
}

/// How much work the next tile gets, from how long the last one took.
double next_budget(double budget, double seconds, double greatest) {
  double const ideal = budget * tile_seconds / std::max(seconds, 1e-6);
  return std::clamp(ideal, std::max(min_budget, budget / 64), std::min(greatest, budget * 16));
}

/// What the planes hold where nothing is, as the device has it.
void begin_centers(Film& film) {
  std::ranges::fill(film.floats(FilmPlane::depth), std::numeric_limits<float>::infinity());
  for (FilmPlane const plane : {FilmPlane::object, FilmPlane::instance, FilmPlane::material}) {
    std::ranges::fill(film.numbers(plane), nothing);
  }
}

/// From the numbers that the device has written (kernels/integrators/first_surface.clh) to those of the film.
/// `flat_instances`: where the device's are in FlatScene::instances.
void number_objects(Film& film, ObjectNumbers const& numbers, std::vector<std::uint32_t> const& flat_instances) {
  auto const objects = film.numbers(FilmPlane::object);
  auto const instances = film.numbers(FilmPlane::instance);
  for (std::size_t i = 0; i < objects.size(); ++i) {
    if (objects[i] == nothing) {
      objects[i] = 0;
      continue;
    }
    std::uint64_t const number = instances[i] == nothing
                                     ? numbers.in_world(objects[i])
                                     : numbers.in_instance(flat_instances[instances[i]], objects[i]);
    objects[i] = std::uint32_t(std::min<std::uint64_t>(number, nothing));
  }
  for (std::uint32_t& number : instances) number = number == nothing ? 0 : flat_instances[number] + 1;
  for (std::uint32_t& number : film.numbers(FilmPlane::material)) ++number;  // from nothing to 0
}

/// Makes the samples of some pixels of a picture as if none had been traced.
void clear_samples(Film& film, Region const& pixels) {
  for (FilmPlane const plane : film.planes().list()) {
    if (info_of(plane).rule != PlaneRule::mean) continue;
    std::size_t const channels = info_of(plane).channels.size();
    auto const row_length = channels * std::size_t(film.region().width);
    for (int y = pixels.y - film.region().y; y < pixels.y - film.region().y + pixels.height; ++y) {
      auto const begin = std::size_t(y) * row_length + channels * std::size_t(pixels.x - film.region().x);
      std::ranges::fill(film.floats(plane).subspan(begin, channels * std::size_t(pixels.width)), 0.0f);
    }
  }
}

struct CompiledScene final : PreparedScene {
  std::shared_ptr<SceneBuffers const> buffers;
  std::shared_ptr<ShadingTables const> tables;  // the buffers' own, unless it is edited
  SceneShading shading;
  SceneContent content;  // as it was prepared, whatever the edits
  ObjectNumbers numbers;
  std::vector<Material const*> materials;  // as the tables list them; only compared with, as they may be gone
};

class OpenClRenderer final : public Renderer {
 public:
  OpenClRenderer(DeviceInfo const& device, Traversal traversal)
      : device_(device), traversal_(traversal), tracer_(device, traversal.grouping) {}

  DeviceInfo const& device() const override { return device_; }

  std::shared_ptr<PreparedScene const> prepare(Scene const& scene, std::string_view root,
                                               std::shared_ptr<PreparedScene const> const& previous) const override {
    auto const* const old = dynamic_cast<CompiledScene const*>(previous.get());
    auto prepared = std::make_shared<CompiledScene>();
    prepared->shading = shading_of(scene);
    SceneStatistics& statistics = prepared->statistics;
    auto start = Clock::now();
    FlatScene flat = flatten(drawn_roots(scene, root));
    for (auto const& material : flat.materials) prepared->materials.push_back(material.get());
    prepared->numbers = ObjectNumbers(flat);
    prepared->lowest_point = lowest_point(flat, unit_vector(scene.up));
    prepared->content = content_of(flat, {scene.lights.begin(), scene.lights.end()}, scene.environment, scene.up);
    prepared->fingerprint = scene_fingerprint(prepared->content, prepared->shading);
    statistics.flatten_ms = 1e3 * seconds_since(start);

    start = Clock::now();
    if (old && old->content == prepared->content) {
      prepared->buffers = old->buffers;
    } else {
      prepared->buffers = std::make_shared<SceneBuffers>(compile_scene(std::move(flat), scene.lights, traversal_.layout,
                                                                       old ? old->buffers.get() : nullptr,
                                                                       scene.environment, scene.up));
    }
    prepared->tables = {prepared->buffers, &prepared->buffers->shading};
    SceneBuffers const& buffers = *prepared->buffers;
    statistics.build_ms = 1e3 * seconds_since(start);
    statistics.triangles = buffers.triangle_count;
    statistics.spheres = buffers.sphere_count + buffers.ellipsoids.size();
    statistics.boxes = buffers.boxes.size();
    statistics.instances = buffers.instances.size();
    statistics.bvh_nodes = buffers.nodes.size() + buffers.wide_nodes.size();
    statistics.unrepresentable = buffers.unrepresentable;
    prepared->bounds = {Vec3(buffers.world_bounds.min), Vec3(buffers.world_bounds.max)};
    return prepared;
  }

  std::shared_ptr<PreparedScene const> edit(std::shared_ptr<PreparedScene const> const& prepared,
                                            SceneEdits const& edits) const override {
    auto const edited = std::make_shared<CompiledScene>(compiled(prepared));
    auto const tables = std::make_shared<ShadingTables>(edit_tables(*edited->buffers, edited->materials, edits));
    if (edits.lights) edited->shading.ambient = ambient(*edits.lights);
    EnvironmentMap const* const map = edited->buffers->shading.environment_table->map.get();
    SceneContent const content = edit_content(edited->content, edited->materials, map, edits);
    edited->fingerprint = scene_fingerprint(content, edited->shading);
    edited->tables = tables;
    return edited;
  }

  SceneStatistics set_scene(std::shared_ptr<PreparedScene const> scene) override {
    CompiledScene const& next = compiled(scene);
    SceneStatistics statistics = next.statistics;
    auto const start = Clock::now();
    tracer_.upload(next.buffers, next.tables);
    scene_ = std::static_pointer_cast<CompiledScene const>(std::move(scene));
    statistics.upload_ms = 1e3 * seconds_since(start);
    statistics.device_bytes = tracer_.device_bytes();
    return statistics;
  }

  RenderResult render(RenderRequest const& request, Film& film, ProgressFunction const& progress) override {
    if (!scene_) throw Error(ErrorKind::usage, "there is no scene to draw: set_scene comes first");
    auto const frame = frame_parameters(request, scene_->shading, scene_->lowest_point);
    SampleRange const wanted = wanted_samples(request);
    if (!has_begun(request, film)) {
      PlaneSet planes = request.planes;
      if (planes.has(FilmPlane::object)) planes.add(FilmPlane::instance);  // it takes both to number objects
      film = Film(request.region, planes, wanted.first);
    }
    RenderResult result;
    Work work{.samples = wanted.end - film.samples().end};
    result.complete = trace_blocks(wanted, film, [&](SampleRange const& samples) {
      return trace(frame, request.integrator, samples, film, work, result.statistics, progress);
    });
    film.keep(request.planes);
    return result;
  }

  Image develop(Film film, Development const& development) override {
    Development known = development;
    if (known.tone_map == ToneMap::automatic) known.tone_map = scene_ ? scene_->shading.tone_map : ToneMap::none;
    return develop_film(std::move(film), known,
                        [&](auto& radiance, auto const& alpha, device::DevelopParameters const& parameters) {
                          // A mean alone takes the host no longer than the device's program takes to load.
                          is_mean(parameters) ? develop_sums(radiance, alpha, parameters)
                                              : tracer_.develop(radiance, alpha, parameters);
                        });
  }

  std::vector<float> filter_noise(NoisyPicture const& picture) override {
    NoisePlanes planes = noise_planes(picture);
    // The host does the same, more slowly.
    if (planes.guides.size() * sizeof(float) > device_.max_allocation_bytes) return lichtraum::filter_noise(picture);
    tracer_.filter_noise(planes);
    return radiance_of(planes, picture);
  }

 private:
  /// What there is to do for one request, and what is done.
  struct Work {
    int samples = 0;  // of each pixel
    double pixel_samples_done = 0;
    double budget = first_budget;
    bool is_stopped = false;
    Clock::time_point start = Clock::now();
  };

  /// Adds samples of one block; false: it was stopped before all of them were there.
  bool trace(device::FrameParameters const& frame, Integrator integrator, SampleRange const& samples, Film& film,
             Work& work, RenderStatistics& statistics, ProgressFunction const& progress) {
    if (work.is_stopped) return false;  // by what was asked after the last tile of the block before
    Region const& region = film.region();
    double const all_work = double(region.width) * double(region.height) * double(work.samples);
    if (samples.first == 0) begin_centers(film);
    auto const progress_now = [&](bool is_compiling) {
      return RenderProgress{work.pixel_samples_done / all_work, statistics.rays.total(), seconds_since(work.start),
                            is_compiling};
    };
    if (progress && tracer_.needs_compiler(frame, integrator, film.planes())) progress(progress_now(true));
    auto const start = Clock::now();
    tracer_.begin_frame(frame, integrator, film);
    statistics.program_ms += 1e3 * seconds_since(start);
    auto const trace_start = Clock::now();
    double const greatest = greatest_budget(device_.kind, scene_->buffers->crowding);
    work.budget = std::min(work.budget, greatest);
    TilePlan plan(region, samples.count(), samples.first, device_.kind == DeviceKind::gpu ? gpu_launch_pixels : 0);
    while (!plan.is_done() && !work.is_stopped) {
      auto const tile_start = Clock::now();
      device::Tile const tile = plan.next(work.budget);
      statistics.rays += tracer_.trace(tile);
      work.budget = next_budget(work.budget, seconds_since(tile_start), greatest);
      work.pixel_samples_done += double(tile.width) * double(tile.height) * double(tile.sample_count);
      work.is_stopped = progress && !progress(progress_now(false));
    }
    tracer_.end_frame();
    if (!plan.is_between_pixels()) clear_samples(film, plan.current_pixels());
    if (samples.first == 0) number_objects(film, scene_->numbers, scene_->buffers->flat_instances);
    statistics.trace_ms += 1e3 * seconds_since(trace_start);
    return plan.is_done();
  }

  static CompiledScene const& compiled(std::shared_ptr<PreparedScene const> const& scene) {
    if (auto const* const known = dynamic_cast<CompiledScene const*>(scene.get())) return *known;
    throw Error(ErrorKind::internal, "the scene was not prepared by this renderer");
  }

  DeviceInfo device_;
  Traversal traversal_;
  TileTracer tracer_;
  std::shared_ptr<CompiledScene const> scene_;
};

}  // namespace

std::unique_ptr<Renderer> make_opencl_renderer(DeviceInfo const& device, Traversal traversal) {
  return std::make_unique<OpenClRenderer>(device, traversal);
}

}  // namespace lichtraum
