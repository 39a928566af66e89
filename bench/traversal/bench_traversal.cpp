// Camera, shadow, bounce and occlusion rays through every layout and through Embree, interleaved in one process.
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "bench_scene.hpp"
#include "contest.hpp"
#include "embree_tracer.hpp"
#include "make_rays.hpp"
#include "mesh_file.hpp"
#include "opencl_tracer.hpp"
#include "render/frame_parameters.hpp"

using namespace lichtraum;
using namespace lichtraum::bench;

namespace {

struct Options {
  std::string model;
  bool floor = false;
  int forest = 0;  ///< instances; 0: the model itself
  std::vector<double> eye{0, 0, 1}, look_at{0, 0, 0}, look_dir, light{0, 1, 0};
  double fov_x_degrees = 46.84;
  std::string size = "1024x768";
  int repetitions = 7;
  int threads = 2;
  int grid = 4;  ///< sub-samples a side
  std::vector<std::string> embree;
  bool high_quality = false;
  std::string json;
  std::vector<std::string> only, layouts{"scalar", "wide", "packet"};
  bool processor_time = false;

  bool wants(std::string const& rays) const {
    return only.empty() || std::find(only.begin(), only.end(), rays) != only.end();
  }
};

Vec3 vec3(std::vector<double> const& v) { return {v[0], v[1], v[2]}; }

double milliseconds(std::function<void()> const& work) {
  auto const start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

/// Of all threads of this process, shared out among `threads`.
double processor_milliseconds(std::function<void()> const& work, int threads) {
  std::clock_t const start = std::clock();
  work();
  return 1e3 * double(std::clock() - start) / CLOCKS_PER_SEC / threads;
}

device::ProjectiveCamera pinhole(Options const& options, Resolution const& size) {
  Vec3 const eye = vec3(options.eye);
  Vec3 const forward = glm::normalize(options.look_dir.empty() ? vec3(options.look_at) - eye : vec3(options.look_dir));
  Vec3 const right = glm::normalize(glm::cross(forward, Vec3(0, 1, 0))), up = glm::cross(right, forward);
  double const half_width = std::tan(glm::radians(0.5 * options.fov_x_degrees));
  double const half_height = half_width * size.height / size.width;
  auto const float4 = [](Vec3 const& v) { return device::float4{float(v.x), float(v.y), float(v.z), 0}; };
  return {float4(eye),
          float4(forward - half_width * right + half_height * up),
          float4(2 * half_width / size.width * right),
          float4(-2 * half_height / size.height * up),
          float4(forward),
          0,
          {}};
}

/// All that is traced.
struct RaySets {
  PrimaryRays primary, samples;
  ShadowRays shadow;
  std::size_t shadow_count = 0;                           ///< of points that send a ray
  std::vector<std::pair<std::string, FreeRays>> bounces;  ///< closest hits: the first bounce, the second, the fourth
  std::vector<std::pair<std::string, FreeRays>> any;      ///< any hit, along the first bounce
};

RaySets make_ray_sets(Options const& options, Resolution const& size, BenchScene const& scene,
                      EmbreeTracer const& tracer) {
  RaySets sets;
  sets.primary = {pinhole(options, size), size.width, size.height, 1};
  sets.samples = {sets.primary.camera, size.width * options.grid, size.height * options.grid,
                  1.0f / float(options.grid)};
  std::vector<RayHit> hits(sets.primary.size());
  tracer.closest(sets.primary, hits, false);
  auto points = surface_points(scene, sets.primary, hits);
  sets.shadow = shadow_rays(points, vec3(options.light), sets.primary);
  sets.shadow_count = std::size_t(std::count_if(points.begin(), points.end(), [](auto const& p) { return p.hit; }));
  for (unsigned bounce = 1; bounce <= 4; ++bounce) {
    FreeRays const rays = bounce_rays(points, bounce);
    if (rays.size() == 0) break;  // all have left
    if (bounce == 1) {
      sets.any = {{"any", rays}, {"any-near", rays}};
      sets.any[1].second.t_max = float(0.1 * diagonal(scene.placements.empty() ? scene.world : scene.object));
    }
    if (bounce != 3) sets.bounces.emplace_back(bounce == 1 ? "bounce" : fmt::format("bounce-{}", bounce), rays);
    hits.resize(rays.size());
    tracer.closest(rays, hits, false);
    points = surface_points(scene, rays, hits);
  }
  return sets;
}

/// Those that are asked for, or all that Debian's packages have installed.
std::vector<std::unique_ptr<embree::Library>> load_embree(std::vector<std::string> const& paths) {
  std::vector<std::unique_ptr<embree::Library>> libraries;
  for (std::string const& path : paths) libraries.push_back(std::make_unique<embree::Library>(path));
  if (!paths.empty()) return libraries;
  for (char const* const name : {"libembree3.so.3", "libembree4.so.4"}) {
    try {
      libraries.push_back(std::make_unique<embree::Library>(name));
    } catch (std::runtime_error const&) {
    }
  }
  if (libraries.empty()) throw std::runtime_error("no Embree is installed: name its library with --embree");
  return libraries;
}

int run(Options const& options) {
  int width = 0, height = 0;
  if (std::sscanf(options.size.c_str(), "%dx%d", &width, &height) != 2 || width < 8 || height < 8 || width % 8 != 0 ||
      height % 8 != 0) {
    throw std::runtime_error("--size is WxH, multiples of 8");
  }
  setenv("POCL_MAX_PTHREAD_COUNT", std::to_string(options.threads).c_str(), 1);
  TriangleMesh mesh = read_mesh(options.model);
  if (options.floor) add_floor(mesh);
  BenchScene const scene =
      options.forest > 0 ? plant_forest(std::move(mesh), options.forest) : BenchScene{std::move(mesh), {}, {}};
  fmt::print("{}{}: {} triangles, {} instances, {} threads\n", options.model, options.floor ? " on a floor" : "",
             scene.triangle_count(), scene.placements.size(), options.threads);

  Clock const clock = [&](std::function<void()> const& work) {
    return options.processor_time ? processor_milliseconds(work, options.threads) : milliseconds(work);
  };

  // Build, alternating.
  auto const libraries = load_embree(options.embree);
  auto const quality = options.high_quality ? EmbreeTracer::Quality::high : EmbreeTracer::Quality::medium;
  std::vector<std::unique_ptr<EmbreeTracer>> peers(libraries.size());
  std::vector<std::vector<double>> peer_build(libraries.size());
  std::vector<double> own_build;
  SceneBuffers wide;
  for (int i = 0; i < std::min(options.repetitions, 5); ++i) {
    for (std::size_t peer = 0; peer < peers.size(); ++peer) {
      peers[peer] = std::make_unique<EmbreeTracer>(*libraries[peer], scene, quality, options.threads);
      peer_build[peer].push_back(clock([&] { peers[peer]->build(); }));
    }
    FlatScene flat = flat_scene(scene);
    wide = {};  // gone before the clock runs
    own_build.push_back(clock([&] { wide = compile_scene(std::move(flat), {}, TreeLayout::wide); }));
  }
  double const triangles = double(scene.triangle_count());
  double const own_bytes = double(sizeof(device::WideNode) * wide.wide_nodes.size() +
                                  sizeof(device::TriangleBlock) * wide.triangle_blocks.size() +
                                  sizeof(device::PrimitiveTag) * wide.triangle_tags.size());
  fmt::print("lichtraum: built in {:.1f} ms, {:.1f} bytes a triangle ({} nodes, {} blocks, stack {})\n",
             median(own_build), own_bytes / triangles, wide.wide_nodes.size(), wide.triangle_blocks.size(),
             wide.stack_size);
  std::string json_peers;
  for (std::size_t peer = 0; peer < peers.size(); ++peer) {
    double const ms = median(peer_build[peer]), bytes = double(peers[peer]->device_bytes()) / triangles;
    fmt::print("Embree {}: built in {:.1f} ms ({:.2f} x), {:.1f} bytes a triangle\n", libraries[peer]->version, ms,
               ms / median(own_build), bytes);
    json_peers += fmt::format("{}\n    {{\"version\": \"{}\", \"build_ms\": {:.3f}, \"bytes_per_triangle\": {:.2f}}}",
                              peer == 0 ? "" : ",", libraries[peer]->version, ms, bytes);
  }

  SceneBuffers scalar = compile_scene(flat_scene(scene), {}, TreeLayout::binary);
  OpenClTracer scalar_tracer(scalar, Traversal::scalar), wide_tracer(wide, Traversal::wide),
      packet_tracer(wide, Traversal::packet);
  RaySets const sets = make_ray_sets(options, {width, height}, scene, *peers.at(0));

  Contest contest;
  auto const add_all = [&](std::string const& name, bool is_peer, auto const& tracer, auto... how) {
    auto const add_hits = [&](std::string const& rays, auto const& set, std::size_t count) {
      if (!options.wants(rays)) return;
      contest.add<RayHit>(rays, name, is_peer, count, set.size(),
                          [=, &tracer, &set](auto& hits) { tracer.closest(set, hits, how...); });
    };
    auto const add_any = [&](std::string const& rays, auto const& set, std::size_t count) {
      if (!options.wants(rays)) return;
      contest.add<std::uint8_t>(rays, name, is_peer, count, set.size(),
                                [=, &tracer, &set](auto& occluded) { tracer.any(set, occluded, how...); });
    };
    add_hits("primary", sets.primary, sets.primary.size());
    add_any("shadow", sets.shadow, sets.shadow_count);
    if (name != "packet") {  // which has free rays traced as `wide` does
      for (auto const& [rays, set] : sets.bounces) add_hits(rays, set, set.count);
      for (auto const& [rays, set] : sets.any) add_any(rays, set, set.count);
    }
    if (name != "scalar" && name != "wide") add_hits("samples", sets.samples, sets.samples.size());
  };
  for (std::size_t peer = 0; peer < peers.size(); ++peer) {
    for (bool const packets : {true, false}) {
      add_all(fmt::format("Embree {} {}", libraries[peer]->version, packets ? "x16" : "x1"), true, *peers[peer],
              packets);
    }
  }
  for (std::string const& layout : options.layouts)
    add_all(layout, false, layout == "scalar" ? scalar_tracer : layout == "wide" ? wide_tracer : packet_tracer);
  contest.run(options.repetitions, clock);
  contest.print();
  if (!options.json.empty()) {
    std::ofstream out(options.json);
    out << fmt::format(
        "{{\n  \"triangles\": {},\n  \"threads\": {},\n  \"build_ms\": {:.3f},\n  \"bytes_per_triangle\": {:.2f},\n"
        "  \"embree\": [{}\n  ],\n  \"results\": [{}\n  ]\n}}\n",
        scene.triangle_count(), options.threads, median(own_build), own_bytes / triangles, json_peers, contest.json());
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app{"Traversal against Embree: camera, shadow, bounce and occlusion rays, interleaved, medians"};
  app.add_option("MODEL", options.model, "a glTF file with triangles")->required();
  auto* const floor = app.add_flag("--floor", options.floor, "put a floor under it");
  app.add_option("--forest", options.forest, "so many instances of it, turned and scaled, on a floor")
      ->check(CLI::PositiveNumber)
      ->excludes(floor);
  app.add_option("--eye", options.eye, "x,y,z")->delimiter(',')->expected(3);
  app.add_option("--look-at", options.look_at, "x,y,z")->delimiter(',')->expected(3);
  app.add_option("--look-dir", options.look_dir, "x,y,z")->delimiter(',')->expected(3);
  app.add_option("--fov", options.fov_x_degrees, "horizontal opening, degrees");
  app.add_option("--light", options.light, "x,y,z of the point light that shadow rays go to")
      ->delimiter(',')
      ->expected(3);
  app.add_option("--size", options.size, "WxH");
  app.add_option("--reps", options.repetitions, "repetitions of each");
  app.add_option("--threads", options.threads);
  app.add_option("--embree", options.embree, "libraries of Embree 3 or 4 to compare with, instead of the installed")
      ->delimiter(',');
  app.add_flag("--high-quality", options.high_quality, "Embree's slower build instead of its medium one");
  app.add_option("--only", options.only,
                 "some of primary, shadow, samples, bounce, bounce-2, bounce-4, any, any-near (along the first "
                 "bounce's rays, to infinity, to a tenth of the model's size)")
      ->delimiter(',');
  app.add_option("--layouts", options.layouts, "some of scalar, wide, packet")
      ->delimiter(',')
      ->check(CLI::IsMember({"scalar", "wide", "packet"}));
  app.add_flag("--processor-time", options.processor_time,
               "measure the threads' time on a processor: for machines that others use as well");
  app.add_option("--json", options.json, "write the results there as well");
  CLI11_PARSE(app, argc, argv);
  try {
    return run(options);
  } catch (std::exception const& error) {
    fmt::print(stderr, "bench_traversal: {}\n", error.what());
    return 1;
  }
}
