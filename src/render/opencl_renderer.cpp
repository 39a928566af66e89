#include "render/opencl_renderer.hpp"

#include <chrono>
#include <limits>

#include "cl/tile_tracer.hpp"
#include "render/drawn_roots.hpp"
#include "render/fingerprint.hpp"
#include "render/frame_parameters.hpp"
#include "render/tile_plan.hpp"
#include "scene/flatten.hpp"

namespace lichtraum {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// A tile should take this long: short enough that a user who interrupts does not wait, long enough that launches
/// (30 microseconds) do not count.
constexpr double tile_seconds = 0.05;
/// Pixels times samples of the first tile, when nothing is known about the scene's cost.
constexpr double first_budget = 1 << 14;
/// One tile's ray counters take 16 bytes a pixel and should stay in the cache.
constexpr double max_budget = 1 << 18;

/// How much work the next tile gets, from how long the last one took.
double next_budget(double budget, double seconds) {
  double const ideal = budget * tile_seconds / std::max(seconds, 1e-6);
  return std::clamp(ideal, std::max(64.0, budget / 64), std::min(max_budget, budget * 16));
}

void clear(Image& image, Region const& region) {
  for (int y = region.y; y < region.y + region.height; ++y) {
    std::fill_n(image.pixel(region.x, y), 3 * region.width, 0.0f);
  }
}

/// From the two numbers that the device has put into each pixel (see kernels/integrators/first_surface.clh) to the
/// object's own.
void number_objects(Image& image, Region const& region, ObjectNumbers const& numbers) {
  auto const number_of = [&](float const* pixel) {
    if (pixel[2] < 0) return std::uint64_t(0);
    auto const high = device::uint(pixel[2]);
    device::uint const shape = device::uint(pixel[0]) | high << 24;
    device::uint const instance = device::uint(pixel[1]) | high >> 8 << 24;
    constexpr device::uint no_instance = 0xffffffffu;
    return instance == no_instance ? numbers.in_world(shape) : numbers.in_instance(instance, shape);
  };
  for (int y = region.y; y < region.y + region.height; ++y) {
    for (int x = region.x; x < region.x + region.width; ++x) {
      float* const pixel = image.pixel(x, y);
      std::fill_n(pixel, 3, float(number_of(pixel)));
    }
  }
}

struct CompiledScene final : PreparedScene {
  std::shared_ptr<SceneBuffers const> buffers;
  std::shared_ptr<ShadingTables const> tables;  // the buffers' own, unless it is edited
  SceneShading shading;
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
    statistics.flatten_ms = 1e3 * seconds_since(start);

    start = Clock::now();
    prepared->buffers = std::make_shared<SceneBuffers>(
        compile_scene(std::move(flat), scene.lights, traversal_.layout, old ? old->buffers.get() : nullptr));
    if (old && old->buffers->content == prepared->buffers->content) prepared->buffers = old->buffers;
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
    prepared->fingerprint = scene_fingerprint(buffers.content, prepared->shading);
    return prepared;
  }

  std::shared_ptr<PreparedScene const> edit(std::shared_ptr<PreparedScene const> const& prepared,
                                            SceneEdits const& edits) const override {
    auto const edited = std::make_shared<CompiledScene>(compiled(prepared));
    auto const tables = std::make_shared<ShadingTables>(edit_tables(*edited->buffers, edited->materials, edits));
    edited->shading.ambient = ambient(edits.lights);
    edited->fingerprint = edited_fingerprint(*edited, *tables);
    edited->tables = tables;
    return edited;
  }

  SceneStatistics set_scene(std::shared_ptr<PreparedScene const> scene) override {
    compiled(scene);
    scene_ = std::static_pointer_cast<CompiledScene const>(std::move(scene));
    SceneStatistics statistics = scene_->statistics;
    auto const start = Clock::now();
    tracer_.upload(scene_->buffers, scene_->tables);
    statistics.upload_ms = 1e3 * seconds_since(start);
    statistics.device_bytes = tracer_.device_bytes();
    return statistics;
  }

  RenderResult render(RenderRequest const& request, Image& image, ProgressFunction const& progress) override {
    auto const frame = frame_parameters(request, scene_->shading);
    if (image.size() != request.resolution) image = Image(request.resolution);
    clear(image, request.region);
    return trace(request, frame, 0, int(frame.sample_count), image, progress);
  }

  RenderResult refine(RenderRequest const& request, Accumulation& sums, Image& image,
                      ProgressFunction const& progress) override {
    bool const is_sum = request.aov == Aov::picture && request.sampling.pattern == Sampling::Pattern::seeded &&
                        request.sampling.count > 1;
    if (!is_sum || sums.count > request.sampling.count || sums.sums.size() != request.resolution) sums = {};
    if (!is_sum) return render(request, image, progress);
    if (sums.count == 0) sums.sums = Image(request.resolution);
    // A picture of more samples than are ever traced stays a sum.
    auto frame = frame_parameters(request, scene_->shading);
    frame.sample_count = std::numeric_limits<device::uint>::max();
    RenderResult const result = trace(request, frame, sums.count, request.sampling.count, sums.sums, progress);
    if (!result.complete) {
      sums = {};
      return result;
    }
    sums.count = request.sampling.count;
    image = sums.sums;
    develop(request, image);
    return result;
  }

 private:
  /// Sums of all samples to a picture, by tiles without any more samples: so their arithmetic is that of `render`.
  void develop(RenderRequest const& request, Image& image) {
    tracer_.begin_frame(frame_parameters(request, scene_->shading), image);
    TilePlan plan(request.region, 1, request.sampling.count);
    while (!plan.is_done()) {
      device::Tile tile = plan.next(max_budget);
      tile.sample_count = 0;
      tracer_.trace(tile);
    }
    tracer_.end_frame();
  }

  /// Adds the samples [first_sample, end_sample).
  RenderResult trace(RenderRequest const& request, device::FrameParameters const& frame, int first_sample,
                     int end_sample, Image& image, ProgressFunction const& progress) {
    int const sample_count = end_sample - first_sample;
    RenderResult result;
    RayCounts& rays = result.statistics.rays;
    double const all_rays = double(request.region.width) * double(request.region.height) * double(sample_count);
    auto const start = Clock::now();
    tracer_.begin_frame(frame, image);
    result.statistics.program_ms = 1e3 * seconds_since(start);
    auto const trace_start = Clock::now();
    TilePlan plan(request.region, sample_count, first_sample);
    double budget = first_budget;
    while (!plan.is_done() && result.complete) {
      auto const tile_start = Clock::now();
      rays += tracer_.trace(plan.next(budget));
      budget = next_budget(budget, seconds_since(tile_start));
      if (progress) result.complete = progress({double(rays.camera) / all_rays, rays.total(), seconds_since(start)});
    }
    tracer_.end_frame();
    result.complete = result.complete || plan.is_done();
    if (!plan.is_between_pixels()) clear(image, plan.current_pixels());
    if (!result.complete && request.aov != Aov::picture) clear(image, request.region);
    if (result.complete && request.aov == Aov::object_id) {
      number_objects(image, request.region, tracer_.scene().object_numbers);
    }
    result.statistics.trace_ms = 1e3 * seconds_since(trace_start);
    return result;
  }

  static CompiledScene const& compiled(std::shared_ptr<PreparedScene const> const& scene) {
    if (auto const* const known = dynamic_cast<CompiledScene const*>(scene.get())) return *known;
    throw Error(ErrorKind::internal, "the scene was not prepared by this renderer");
  }

  static std::string edited_fingerprint(CompiledScene const& scene, ShadingTables const& tables) {
    ContentHasher hasher;
    hasher.add(scene.buffers->content.words);
    hasher.add(tables.materials);
    hasher.add(tables.pbr_materials);
    hasher.add(tables.lights);
    return scene_fingerprint(hasher.finish(), scene.shading);
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
