#include "reference/renderer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "core/start_threads.hpp"
#include "film/check_request.hpp"
#include "film/trace_blocks.hpp"
#include "lichtraum/error.hpp"
#include "lichtraum/graph_summary.hpp"
#include "reference/row_queue.hpp"
#include "reference/scene.hpp"
#include "scene/copy_graph.hpp"
#include "scene/flatten.hpp"
#include "scene/graph_order.hpp"
#include "scene/lowest_point.hpp"
#include "scene/scene_content.hpp"
#include "scene/unit_vector.hpp"

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

struct PreparedGraph final : PreparedScene {
  ReferenceScene graph;
  std::vector<Light> lights;  // those that surround as well
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
    prepared->lights.assign(scene.lights.begin(), scene.lights.end());
    identify(*prepared);
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
    if (edits.lights) edited->lights = *edits.lights;
    edited->graph.ambient = ambient(edited->lights);
    edited->graph.lights = casting_shadows(edited->lights);
    edited->graph.environment = edits.environment;
    auto const copies = copy_graph(graph->graph.roots, edits.materials);
    edited->graph.roots.assign(copies.begin(), copies.end());
    identify(*edited);
    return edited;
  }

  SceneStatistics set_scene(std::shared_ptr<PreparedScene const> scene) override {
    scene_ = std::dynamic_pointer_cast<PreparedGraph const>(std::move(scene));
    if (!scene_) throw Error(ErrorKind::internal, "the scene was not prepared by this renderer");
    return scene_->statistics;
  }

  RenderResult render(RenderRequest const& request, Film& film, ProgressFunction const& progress) override {
    if (!scene_) throw Error(ErrorKind::usage, "there is no scene to draw: set_scene comes first");
    check_request(request);
    SampleRange const wanted = wanted_samples(request);
    if (!has_begun(request, film)) film = Film(request.region, request.planes, wanted.first);
    RenderResult result;
    auto const start = Clock::now();
    int const sample_count = wanted.end - film.samples().end;
    int samples_before = 0;
    auto const goes_on = [&](double samples_done, RayCounts const& rays) {
      return !progress || progress({samples_done / sample_count, rays.total(), seconds_since(start)});
    };
    result.complete = trace_blocks(wanted, film, [&](SampleRange const& samples) {
      if (samples_before > 0 && !goes_on(samples_before, result.statistics.rays)) return false;
      PixelTracer const pixels(scene_->graph, scene_->numbers, request, samples, film);
      RowQueue rows(pixels, request.region);
      RayCounts const rays_before = result.statistics.rays;
      bool const is_done = trace_rows(rows, [&] {
        RayCounts rays = rays_before;
        rays += rows.rays();
        return goes_on(samples_before + rows.fraction() * samples.count(), rays);
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
    if (known.tone_map == ToneMap::automatic) known.tone_map = scene_ ? scene_->graph.tone_map : ToneMap::none;
    return lichtraum::develop(std::move(film), known);
  }

  std::vector<float> filter_noise(NoisyPicture const& picture) override { return lichtraum::filter_noise(picture); }

 private:
  /// The numbers and the fingerprint of what it draws.
  static void identify(PreparedGraph& prepared) {
    FlatScene const flat = flatten(prepared.graph.roots);
    auto& materials = prepared.numbers.materials;
    materials.clear();
    for (std::size_t i = 0; i < flat.materials.size(); ++i) {
      materials.emplace(flat.materials[i].get(), std::uint32_t(i + 1));
    }
    prepared.numbers.objects = ObjectNumbers(flat);
    prepared.lowest_point = prepared.graph.lowest_point = lowest_point(flat, unit_vector(prepared.graph.up));
    prepared.fingerprint = scene_fingerprint(
        content_of(flat, prepared.lights, prepared.graph.environment, prepared.graph.up), prepared.graph);
  }

  /// Whether all rows are there: not where `goes_on` has said no.
  template <class GoesOn>
  bool trace_rows(RowQueue& rows, GoesOn const& goes_on) const {
    {
      unsigned const count = std::clamp(device_.compute_units, 1u, unsigned(rows.count()));
      auto threads = start_threads(count, [&rows](std::stop_token const& stop, std::size_t) { rows.work(stop); });
      if (threads.empty()) rows.work({});
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
  std::shared_ptr<PreparedGraph const> scene_;
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
