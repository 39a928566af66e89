#include "render/reference_renderer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>

#include "compile/scene_buffers.hpp"
#include "lichtraum/error.hpp"
#include "lichtraum/graph_summary.hpp"
#include "render/check_request.hpp"
#include "render/fingerprint.hpp"
#include "render/reference_integrator.hpp"
#include "render/reference_scene.hpp"
#include "render/reference_surfaces.hpp"
#include "render/trace_blocks.hpp"
#include "scene/copy_graph.hpp"
#include "scene/flatten.hpp"
#include "scene/graph_order.hpp"
#include "shared/sampling.h"

namespace lichtraum {
namespace {

constexpr std::uint64_t most_primitives = 10'000'000;
constexpr auto progress_interval = std::chrono::milliseconds(40);

using Clock = std::chrono::steady_clock;

/// How often shapes are shown that are shown more than once.
std::uint64_t count_instances(std::vector<std::shared_ptr<Shape const>> const& roots) {
  std::uint64_t count = 0;
  for (GraphNode const& node : order_graph(roots).nodes) count += node.edges_in > 1 ? node.edges_in : 0;
  return count;
}

/// Where sample `index` of a pixel lies, from the pixel's top left corner.
glm::dvec2 sample_offset(RenderRequest const& request, int x, int y, int index) {
  if (request.sampling.pattern == Sampling::Pattern::grid) {
    auto const side = static_cast<int>(std::lround(std::sqrt(double(request.sampling.count))));
    return glm::dvec2(index % side + 0.5, index / side + 0.5) / double(side);
  }
  if (request.sampling.count == 1) return glm::dvec2(0.5);
  auto const offset = device::seeded_pixel_offset(
      static_cast<device::uint>(x), static_cast<device::uint>(y), static_cast<device::uint>(index),
      static_cast<device::uint>(request.seed), static_cast<device::uint>(request.seed >> 32));
  return {offset.x, offset.y};
}

/// A pixel of a plane of the film: where its values are.
class PixelOf {
 public:
  PixelOf(Film& film, std::size_t pixel) : film_(film), pixel_(pixel) {}
  void add(FilmPlane plane, Vec3 const& value) {
    std::size_t const channels = info_of(plane).channels.size();
    for (std::size_t c = 0; c < channels && film_.planes().has(plane); ++c) {
      film_.floats(plane)[channels * pixel_ + c] += float(value[int(c)]);
    }
  }
  void set(FilmPlane plane, std::uint32_t number) {
    if (film_.planes().has(plane)) film_.numbers(plane)[pixel_] = number;
  }

 private:
  Film& film_;
  std::size_t pixel_;
};

bool is_finite(Rgb const& c) { return std::isfinite(c.r) && std::isfinite(c.g) && std::isfinite(c.b); }

/// What is traced of a pixel at once: samples of one block.
class PixelTracer {
 public:
  PixelTracer(ReferenceScene const& scene, ReferenceNumbers const& numbers, RenderRequest const& request,
              SampleRange const& samples, Film& film)
      : scene_(scene), surfaces_(scene, numbers, request.planes), request_(request), samples_(samples), film_(film) {
    if (request.background) scene_.background = *request.background;
  }

  void trace(int x, int y, RayCounts& counts) const {
    Region const& region = film_.region();
    PixelOf pixel(film_, std::size_t(y - region.y) * std::size_t(region.width) + std::size_t(x - region.x));
    if (samples_.first == 0 && film_.planes().has(PlaneRule::center)) trace_center(x, y, pixel, counts);
    if (film_.planes().has(PlaneRule::mean)) trace_samples(x, y, pixel, counts);
  }

 private:
  void trace_center(int x, int y, PixelOf& pixel, RayCounts& counts) const {
    auto const center = surfaces_.center(request_.camera.generate_ray(x + 0.5, y + 0.5, request_.resolution));
    ++counts.camera;
    counts.camera_hits += std::isfinite(center.depth);
    pixel.add(FilmPlane::depth, Vec3(center.depth));
    pixel.add(FilmPlane::position, center.position);
    pixel.set(FilmPlane::object, center.object);
    pixel.set(FilmPlane::instance, center.instance);
    pixel.set(FilmPlane::material, center.material);
  }

  void trace_samples(int x, int y, PixelOf& pixel, RayCounts& counts) const {
    PlaneSet const& planes = film_.planes();
    bool const has_surfaces =
        planes.has(FilmPlane::alpha) || planes.has(FilmPlane::albedo) || planes.has(FilmPlane::normal);
    for (int i = samples_.first; i < samples_.end; ++i) {
      auto const offset = sample_offset(request_, x, y, i);
      Ray const ray = request_.camera.generate_ray(x + offset.x, y + offset.y, request_.resolution);
      bool is_hit = false;
      if (has_surfaces) {
        auto const surface = surfaces_.sample(ray);
        is_hit = surface.alpha > 0;
        pixel.add(FilmPlane::alpha, Vec3(surface.alpha));
        pixel.add(FilmPlane::albedo, surface.albedo);
        pixel.add(FilmPlane::normal, surface.normal);
      }
      if (planes.has(FilmPlane::radiance)) {
        Rgb const radiance = trace_radiance(scene_, ray, request_.max_depth, counts);
        if (planes.has(FilmPlane::alpha) && !is_hit) continue;
        if (is_finite(radiance)) {
          pixel.add(FilmPlane::radiance, radiance);
        } else {
          ++counts.not_finite;
        }
      } else {
        ++counts.camera;
        counts.camera_hits += is_hit;
      }
    }
  }

  ReferenceScene scene_;
  ReferenceSurfaces surfaces_;
  RenderRequest const& request_;
  SampleRange samples_;
  Film& film_;
};

/// One render: threads take rows from the region until none is left or they are told to stop.
class RowQueue {
 public:
  RowQueue(PixelTracer const& pixels, Region const& region) : pixels_(pixels), region_(region) {}

  void work(std::stop_token const& stop) {
    try {
      while (!stop.stop_requested()) {
        int const row = next_row_.fetch_add(1, std::memory_order_relaxed);
        if (row >= region_.height || !trace_row(row, stop)) break;
      }
    } catch (...) {
      std::lock_guard const lock(mutex_);
      failure_ = std::current_exception();
    }
    changed_.notify_all();
  }

  /// Waits for the last row or the interval; true when there is nothing more to wait for.
  bool wait_for(Clock::duration interval) {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, interval, [this] { return failure_ || finished_rows_ == region_.height; });
  }

  int count() const { return region_.height; }
  double fraction() {
    std::lock_guard const lock(mutex_);
    return double(finished_rows_) / region_.height;
  }
  RayCounts rays() {
    std::lock_guard const lock(mutex_);
    return rays_;
  }
  /// Once all threads have ended: whether every row is there.
  bool finish() {
    if (failure_) std::rethrow_exception(failure_);
    return finished_rows_ == region_.height;
  }

 private:
  bool trace_row(int row, std::stop_token const& stop) {
    RayCounts counts;
    for (int x = region_.x; x < region_.x + region_.width; ++x) {
      if (stop.stop_requested()) return false;
      pixels_.trace(x, region_.y + row, counts);
    }
    std::lock_guard const lock(mutex_);
    rays_ += counts;
    ++finished_rows_;
    return true;
  }

  PixelTracer const& pixels_;
  Region region_;
  std::atomic<int> next_row_{0};
  std::mutex mutex_;  // guards what follows
  std::condition_variable changed_;
  int finished_rows_ = 0;
  RayCounts rays_;
  std::exception_ptr failure_;
};

struct PreparedGraph final : PreparedScene {
  ReferenceScene graph;
  ReferenceNumbers numbers;
};

class ReferenceRenderer final : public Renderer {
 public:
  explicit ReferenceRenderer(DeviceInfo const& device) : device_(device) {}

  DeviceInfo const& device() const override { return device_; }

  std::shared_ptr<PreparedScene const> prepare(Scene const& scene, std::string_view root,
                                               std::shared_ptr<PreparedScene const> const&) const override {
    auto prepared = std::make_shared<PreparedGraph>();
    ReferenceScene& drawn = prepared->graph = make_reference_scene(scene, root);
    GraphSummary const summary = summarise(drawn.roots);
    std::uint64_t const primitives = summary.drawn.primitives();
    if (primitives > most_primitives) {
      throw Error(
          ErrorKind::no_device,
          fmt::format("the scene draws {:.3g} primitives, and the reference device, which tests every ray against "
                      "each, takes at most {:.3g}",
                      double(primitives), double(most_primitives)));
    }
    auto const copies = copy_graph(drawn.roots);
    drawn.roots.assign(copies.begin(), copies.end());
    identify(*prepared, scene.lights);
    prepared->statistics.triangles = summary.defined[ShapeKind::triangle] + summary.defined.mesh_triangles;
    prepared->statistics.spheres = summary.defined[ShapeKind::sphere];
    prepared->statistics.boxes = summary.defined[ShapeKind::box];
    prepared->statistics.instances = count_instances(drawn.roots);
    prepared->bounds = summary.bounds;
    return prepared;
  }

  std::shared_ptr<PreparedScene const> edit(std::shared_ptr<PreparedScene const> const& prepared,
                                            SceneEdits const& edits) const override {
    auto const* const graph = dynamic_cast<PreparedGraph const*>(prepared.get());
    if (!graph) throw Error(ErrorKind::internal, "the scene was not prepared by this renderer");
    auto edited = std::make_shared<PreparedGraph>(*graph);
    edited->graph.ambient = ambient(edits.lights);
    edited->graph.lights = casting_shadows(edits.lights);
    auto const copies = copy_graph(graph->graph.roots, edits.materials);
    edited->graph.roots.assign(copies.begin(), copies.end());
    Registry<Light> lights;
    for (Light const& light : edits.lights) lights.insert(light);
    identify(*edited, lights);
    return edited;
  }

  SceneStatistics set_scene(std::shared_ptr<PreparedScene const> scene) override {
    scene_ = std::dynamic_pointer_cast<PreparedGraph const>(std::move(scene));
    if (!scene_) throw Error(ErrorKind::internal, "the scene was not prepared by this renderer");
    return scene_->statistics;
  }

  RenderResult render(RenderRequest const& request, Film& film, ProgressFunction const& progress) override {
    check_request(request);
    SampleRange const wanted = wanted_samples(request);
    if (!has_begun(request, film)) film = Film(request.region, request.planes, wanted.first);
    RenderResult result;
    auto const start = Clock::now();
    int const sample_count = wanted.end - film.samples().end;
    int samples_before = 0;
    result.complete = trace_blocks(wanted, film, [&](SampleRange const& samples) {
      PixelTracer const pixels(scene_->graph, scene_->numbers, request, samples, film);
      RowQueue rows(pixels, request.region);
      RayCounts const rays_before = result.statistics.rays;
      bool const is_done = trace_rows(rows, [&] {
        double const done = samples_before + rows.fraction() * samples.count();
        RayCounts rays = rays_before;
        rays += rows.rays();
        return !progress || progress({done / sample_count, rays.total(), seconds_since(start)});
      });
      result.statistics.rays += rows.rays();
      samples_before += samples.count();
      return is_done;
    });
    result.statistics.trace_ms = 1e3 * seconds_since(start);
    return result;
  }

  Image develop(Film film, Development const& development) override {
    Development known = development;
    if (known.tone_map == ToneMap::automatic) known.tone_map = scene_->graph.tone_map;
    return lichtraum::develop(std::move(film), known);
  }

 private:
  static void identify(PreparedGraph& prepared, Registry<Light> const& lights) {
    FlatScene flat = flatten(prepared.graph.roots);
    auto& materials = prepared.numbers.materials;
    materials.clear();
    for (std::size_t i = 0; i < flat.materials.size(); ++i) {
      materials.emplace(flat.materials[i].get(), std::uint32_t(i + 1));
    }
    SceneBuffers const compiled = compile_scene(std::move(flat), lights, TreeLayout::binary);
    prepared.numbers.objects = compiled.object_numbers;
    prepared.fingerprint = scene_fingerprint(compiled.content, prepared.graph);
  }

  /// Whether all rows are there: not where `goes_on` has said no.
  template <class GoesOn>
  bool trace_rows(RowQueue& rows, GoesOn const& goes_on) const {
    {
      std::vector<std::jthread> threads;
      unsigned const count = std::clamp(device_.compute_units, 1u, unsigned(rows.count()));
      for (unsigned i = 0; i < count; ++i) {
        threads.emplace_back([&rows](std::stop_token const& stop) { rows.work(stop); });
      }
      while (!rows.wait_for(progress_interval)) {
        if (goes_on()) continue;
        for (std::jthread& thread : threads) thread.request_stop();
        break;
      }
    }  // joins the threads, also when `goes_on` throws
    return rows.finish();
  }

  static double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
  }

  DeviceInfo device_;
  std::shared_ptr<PreparedGraph const> scene_ = std::make_shared<PreparedGraph>();
};

}  // namespace

DeviceInfo reference_device() {
  DeviceInfo device;
  device.kind = DeviceKind::reference;
  device.name = "reference";
  device.platform = "lichtraum";
  device.platform_version = LICHTRAUM_VERSION;
  device.device_version = "C++ in double precision";
  device.driver_version = LICHTRAUM_VERSION;
  device.compute_units = std::max(1u, std::thread::hardware_concurrency());
  return device;
}

std::unique_ptr<Renderer> make_reference_renderer(DeviceInfo const& device) {
  return std::make_unique<ReferenceRenderer>(device);
}

}  // namespace lichtraum
