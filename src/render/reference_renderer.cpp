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
#include "render/reference_aov.hpp"
#include "render/reference_integrator.hpp"
#include "render/reference_scene.hpp"
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

Rgb trace_pixel(ReferenceScene const& scene, ReferenceAov const& aov, RenderRequest const& request, int x, int y,
                RayCounts& counts) {
  if (request.aov != Aov::picture) {
    return aov.trace(request.camera.generate_ray(x + 0.5, y + 0.5, request.resolution), counts);
  }
  Rgb sum(0);
  for (int i = 0; i < request.sampling.count; ++i) {
    auto const offset = sample_offset(request, x, y, i);
    Ray const ray = request.camera.generate_ray(x + offset.x, y + offset.y, request.resolution);
    sum += trace_radiance(scene, ray, request.max_depth, counts);
  }
  return sum / double(request.sampling.count);
}

/// One render: threads take rows from the region until none is left or they are told to stop.
class RowQueue {
 public:
  RowQueue(ReferenceScene const& scene, RenderRequest const& request, Image& image)
      : scene_(scene), aov_(scene, request.aov), request_(request), image_(image) {
    if (request_.tone_map == ToneMap::automatic) request_.tone_map = scene.tone_map;
    if (request_.aov != Aov::picture) {
      request_.tone_map = ToneMap::none;
      request_.transfer = Transfer::linear;
    }
    for (int y = 0; y < request.region.height; ++y) {
      float* const row = image_.pixel(request.region.x, request.region.y + y);
      std::fill(row, row + 3 * request.region.width, 0.0f);
    }
  }

  void work(std::stop_token const& stop) {
    try {
      while (!stop.stop_requested()) {
        int const row = next_row_.fetch_add(1, std::memory_order_relaxed);
        if (row >= request_.region.height || !trace_row(row, stop)) break;
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
    return changed_.wait_for(lock, interval, [this] { return failure_ || finished_rows_ == request_.region.height; });
  }

  double fraction() {
    std::lock_guard const lock(mutex_);
    return double(finished_rows_) / request_.region.height;
  }
  RayCounts rays() {
    std::lock_guard const lock(mutex_);
    return rays_;
  }
  /// Once all threads have ended: whether every row is there.
  bool finish() {
    if (failure_) std::rethrow_exception(failure_);
    return finished_rows_ == request_.region.height;
  }

 private:
  // A row that is given up stays black.
  bool trace_row(int row, std::stop_token const& stop) {
    Region const& region = request_.region;
    int const y = region.y + row;
    RayCounts counts;
    std::vector<float> pixels;
    pixels.reserve(3 * static_cast<std::size_t>(region.width));
    for (int x = region.x; x < region.x + region.width; ++x) {
      if (stop.stop_requested()) return false;
      Rgb const color =
          develop(trace_pixel(scene_, aov_, request_, x, y, counts), request_.tone_map, request_.transfer);
      for (int channel = 0; channel < 3; ++channel) pixels.push_back(static_cast<float>(color[channel]));
    }
    std::copy(pixels.begin(), pixels.end(), image_.pixel(region.x, y));
    std::lock_guard const lock(mutex_);
    rays_ += counts;
    ++finished_rows_;
    return true;
  }

  ReferenceScene const& scene_;
  ReferenceAov aov_;
  RenderRequest request_;
  Image& image_;
  std::atomic<int> next_row_{0};
  std::mutex mutex_;  // guards what follows
  std::condition_variable changed_;
  int finished_rows_ = 0;
  RayCounts rays_;
  std::exception_ptr failure_;
};

struct PreparedGraph final : PreparedScene {
  ReferenceScene graph;
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
    SceneBuffers const compiled = compile_scene(flatten(drawn.roots), scene.lights, TreeLayout::binary);
    prepared->fingerprint = scene_fingerprint(compiled.content, drawn);
    auto const copies = copy_graph(drawn.roots);
    drawn.roots.assign(copies.begin(), copies.end());
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
    SceneBuffers const compiled = compile_scene(flatten(edited->graph.roots), lights, TreeLayout::binary);
    edited->fingerprint = scene_fingerprint(compiled.content, edited->graph);
    return edited;
  }

  SceneStatistics set_scene(std::shared_ptr<PreparedScene const> scene) override {
    scene_ = std::dynamic_pointer_cast<PreparedGraph const>(std::move(scene));
    if (!scene_) throw Error(ErrorKind::internal, "the scene was not prepared by this renderer");
    return scene_->statistics;
  }

  RenderResult render(RenderRequest const& request, Image& image, ProgressFunction const& progress) override {
    check_request(request);
    if (image.size() != request.resolution) image = Image(request.resolution);
    auto const start = Clock::now();
    RowQueue rows(scene_->graph, request, image);
    {
      std::vector<std::jthread> threads;
      unsigned const count = std::clamp(device_.compute_units, 1u, static_cast<unsigned>(request.region.height));
      for (unsigned i = 0; i < count; ++i) {
        threads.emplace_back([&rows](std::stop_token const& stop) { rows.work(stop); });
      }
      while (!rows.wait_for(progress_interval)) {
        if (progress && !progress({rows.fraction(), rows.rays().total(), seconds_since(start)})) {
          for (std::jthread& thread : threads) thread.request_stop();
          break;
        }
      }
    }  // joins the threads, also when `progress` throws
    RenderResult result;
    result.complete = rows.finish();
    result.statistics.rays = rows.rays();
    result.statistics.trace_ms = 1e3 * seconds_since(start);
    return result;
  }

 private:
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
