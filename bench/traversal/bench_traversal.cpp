// Primary, shadow and diffuse-bounce rays through every layout and through Embree, interleaved in one process.
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <functional>
#include <glm/trigonometric.hpp>
#include <random>

#include "embree_tracer.hpp"
#include "lichtraum/camera.hpp"
#include "mesh_file.hpp"
#include "opencl_tracer.hpp"
#include "render/frame_parameters.hpp"

using namespace lichtraum;
using namespace lichtraum::bench;

namespace {

struct Options {
  std::string model;
  std::vector<double> eye{0, 0, 1}, look_at, look_dir, light{0, 1, 0};
  double fov_x_degrees = 46.84;
  std::string size = "1024x768";
  int repetitions = 7;
  int threads = 2;
  int grid = 4;  ///< sub-samples a side
  std::string json;
  std::string only;
  std::string layouts = "scalar,wide,packet";
  bool processor_time = false;
};

Vec3 vec3(std::vector<double> const& v) { return {v[0], v[1], v[2]}; }
Vec3 vec3(std::array<float, 3> const& v) { return {v[0], v[1], v[2]}; }

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

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + std::ptrdiff_t(values.size() / 2), values.end());
  return values[values.size() / 2];
}

FlatScene flat_scene(TriangleMesh const& mesh) {
  FlatScene scene;
  scene.objects.resize(1);
  auto& triangles = scene.objects[0].triangles;
  triangles.reserve(mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    device::TrianglePrimitive triangle{};
    for (int corner = 0; corner < 3; ++corner) {
      auto const& position = mesh.positions[mesh.triangles[i][std::size_t(corner)]];
      std::copy(position.begin(), position.end(), triangle.vertices[corner]);
    }
    triangle.tag = {0, device::uint(i)};
    triangles.push_back(triangle);
  }
  return scene;
}

device::PinholeCamera pinhole(Options const& options, Resolution const& size) {
  Vec3 const eye = vec3(options.eye);
  Vec3 const forward = glm::normalize(options.look_dir.empty() ? vec3(options.look_at) - eye : vec3(options.look_dir));
  Vec3 const right = glm::normalize(glm::cross(forward, Vec3(0, 1, 0))), up = glm::cross(right, forward);
  double const half_width = std::tan(glm::radians(0.5 * options.fov_x_degrees));
  double const half_height = half_width * size.height / size.width;
  auto const float4 = [](Vec3 const& v) { return device::float4{float(v.x), float(v.y), float(v.z), 0}; };
  return {float4(eye), float4(forward - half_width * right + half_height * up),
          float4(2 * half_width / size.width * right), float4(-2 * half_height / size.height * up)};
}

/// What a hit says about the surface: a point off it on the viewer's side, and its normal there.
struct SurfacePoint {
  bool hit = false;
  Vec3 position{0}, normal{0};
};

std::vector<SurfacePoint> surface_points(TriangleMesh const& mesh, PrimaryRays const& rays,
                                         std::vector<RayHit> const& hits) {
  std::vector<SurfacePoint> points(hits.size());
  for (std::size_t i = 0; i < hits.size(); ++i) {
    if (!std::isfinite(hits[i].t)) continue;
    double const x = double(i % std::size_t(rays.width)) + 0.5, y = double(i / std::size_t(rays.width)) + 0.5;
    auto const v = [](device::float4 const& f) { return Vec3(f.x, f.y, f.z); };
    Vec3 const direction = v(rays.camera.corner) + x * v(rays.camera.step_x) + y * v(rays.camera.step_y);
    auto const& [a, b, c] = mesh.triangles[hits[i].triangle];
    Vec3 const pa = vec3(mesh.positions[a]), pb = vec3(mesh.positions[b]), pc = vec3(mesh.positions[c]);
    Vec3 normal = glm::cross(pb - pa, pc - pa);
    if (!(glm::length(normal) > 0)) continue;
    normal = glm::normalize(normal);
    if (glm::dot(normal, direction) > 0) normal = -normal;
    double const t = double(hits[i].t);
    points[i] = {true, v(rays.camera.origin) + t * direction + 1e-4 * t * glm::length(direction) * normal, normal};
  }
  return points;
}

ShadowRays shadow_rays(std::vector<SurfacePoint> const& points, Vec3 const& light, PrimaryRays const& rays) {
  ShadowRays shadow{{}, {float(light.x), float(light.y), float(light.z), 0}, rays.width, rays.height};
  for (SurfacePoint const& p : points) {
    shadow.points.push_back({float(p.position.x), float(p.position.y), float(p.position.z), p.hit ? 1.0f : 0.0f});
  }
  return shadow;
}

/// Cosine-distributed about the normals, from a seeded sequence.
FreeRays bounce_rays(std::vector<SurfacePoint> const& points) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(0, 1);
  FreeRays rays;
  for (SurfacePoint const& p : points) {
    double const z = 2 * unit(random) - 1, phi = 2 * 3.14159265358979 * unit(random), r = std::sqrt(1 - z * z);
    Vec3 const direction = glm::normalize(p.normal + Vec3(r * std::cos(phi), r * std::sin(phi), z) * 0.999);
    if (!p.hit) continue;
    rays.origins.push_back({float(p.position.x), float(p.position.y), float(p.position.z), 0});
    rays.directions.push_back({float(direction.x), float(direction.y), float(direction.z), 0});
  }
  std::size_t const padded =
      (rays.size() + FreeRays::rays_per_item - 1) / FreeRays::rays_per_item * FreeRays::rays_per_item;
  rays.origins.resize(padded, {});
  rays.directions.resize(padded, {});
  return rays;
}

/// One way to trace one set of rays.
struct Contestant {
  std::string rays, name;
  std::size_t ray_count = 0;
  std::function<void()> run;
  std::function<double()> disagreement;  ///< share of rays whose result is not the reference's
  std::vector<double> ms = {};
};

double share_different(std::vector<RayHit> const& a, std::vector<RayHit> const& b) {
  std::size_t different = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    bool const same = a[i].t == b[i].t || std::abs(a[i].t - b[i].t) <= 1e-4f * std::abs(b[i].t);
    different += same ? 0 : 1;
  }
  return double(different) / double(a.size());
}

double share_different(std::vector<std::uint8_t> const& a, std::vector<std::uint8_t> const& b) {
  std::size_t different = 0;
  for (std::size_t i = 0; i < a.size(); ++i) different += a[i] != b[i];
  return double(different) / double(a.size());
}

int run(Options const& options) {
  int width = 0, height = 0;
  if (std::sscanf(options.size.c_str(), "%dx%d", &width, &height) != 2 || width < 8 || height < 8 || width % 8 != 0 ||
      height % 8 != 0) {
    throw std::runtime_error("--size is WxH, multiples of 8");
  }
  setenv("POCL_MAX_PTHREAD_COUNT", std::to_string(options.threads).c_str(), 1);
  TriangleMesh const mesh = read_mesh(options.model);
  fmt::print("{}: {} triangles, {} threads\n", options.model, mesh.triangles.size(), options.threads);

  // Build, alternating.
  std::vector<double> embree_build, embree_high_build, own_build;
  std::unique_ptr<EmbreeTracer> embree, embree_high;
  SceneBuffers wide, scalar;
  for (int i = 0; i < std::min(options.repetitions, 5); ++i) {
    embree = std::make_unique<EmbreeTracer>(mesh, EmbreeTracer::Quality::medium, options.threads);
    embree_build.push_back(options.processor_time ? embree->build_processor_ms() / options.threads
                                                  : embree->build_ms());
    FlatScene flat = flat_scene(mesh);
    wide = {};  // gone before the clock runs
    auto const compile = [&] { wide = compile_scene(std::move(flat), {}, TreeLayout::wide); };
    own_build.push_back(options.processor_time ? processor_milliseconds(compile, options.threads)
                                               : milliseconds(compile));
  }
  embree_high = std::make_unique<EmbreeTracer>(mesh, EmbreeTracer::Quality::high, options.threads);
  scalar = compile_scene(flat_scene(mesh), {}, TreeLayout::binary);
  double const triangles = double(mesh.triangles.size());
  double const own_bytes = double(sizeof(device::WideNode) * wide.wide_nodes.size() +
                                  sizeof(device::TriangleBlock) * wide.triangle_blocks.size() +
                                  sizeof(device::PrimitiveTag) * wide.triangle_tags.size());
  fmt::print("build: Embree medium {:.1f} ms, high {:.1f} ms, lichtraum {:.1f} ms: {:.2f} x medium's speed\n",
             median(embree_build), embree_high->build_ms(), median(own_build),
             median(embree_build) / median(own_build));
  fmt::print("bytes per triangle: Embree medium {:.1f}, lichtraum {:.1f} ({:.2f} x; {} nodes, {} blocks, stack {})\n",
             double(embree->device_bytes()) / triangles, own_bytes / triangles,
             own_bytes / double(embree->device_bytes()), wide.wide_nodes.size(), wide.triangle_blocks.size(),
             wide.stack_size);

  OpenClTracer scalar_tracer(scalar, Traversal::scalar), wide_tracer(wide, Traversal::wide),
      packet_tracer(wide, Traversal::packet);

  Resolution const size{width, height};
  PrimaryRays const primary{pinhole(options, size), width, height, 1};
  PrimaryRays const sampled{primary.camera, width * options.grid, height * options.grid, 1.0f / float(options.grid)};
  std::vector<RayHit> reference(primary.size());
  embree->closest(primary, reference, false);
  auto const points = surface_points(mesh, primary, reference);
  ShadowRays const shadow = shadow_rays(points, vec3(options.light), primary);
  FreeRays const bounce = bounce_rays(points);
  std::vector<RayHit> bounce_reference(bounce.size()), sampled_reference(sampled.size());
  embree->closest(bounce, bounce_reference, false);
  embree->closest(sampled, sampled_reference, false);
  std::vector<std::uint8_t> shadow_reference(shadow.size());
  embree->any(shadow, shadow_reference, false);

  std::vector<RayHit> hits(primary.size()), bounce_hits(bounce.size()), sampled_hits(sampled.size());
  std::vector<std::uint8_t> occluded(shadow.size());
  std::vector<Contestant> contestants;
  std::size_t const shadow_count =
      std::size_t(std::count_if(points.begin(), points.end(), [](auto const& p) { return p.hit; }));
  auto const wanted = [&](std::string const& rays) {
    return options.only.empty() || options.only.find(rays) != std::string::npos;
  };
  auto const add_primary = [&](std::string name, std::function<void()> f) {
    if (wanted("primary"))
      contestants.push_back({"primary", name, primary.size(), f, [&] { return share_different(hits, reference); }});
  };
  auto const add_sampled = [&](std::string name, std::function<void()> f) {
    if (wanted("samples"))
      contestants.push_back(
          {"samples", name, sampled.size(), f, [&] { return share_different(sampled_hits, sampled_reference); }});
  };
  auto const add_shadow = [&](std::string name, std::function<void()> f) {
    if (wanted("shadow"))
      contestants.push_back(
          {"shadow", name, shadow_count, f, [&] { return share_different(occluded, shadow_reference); }});
  };
  auto const add_bounce = [&](std::string name, std::function<void()> f) {
    if (wanted("bounce"))
      contestants.push_back(
          {"bounce", name, shadow_count, f, [&] { return share_different(bounce_hits, bounce_reference); }});
  };
  for (bool const packets : {true, false}) {
    for (auto* tracer : {embree.get(), embree_high.get()}) {
      std::string const name =
          fmt::format("Embree {} {}", packets ? "16" : "1", tracer == embree.get() ? "medium" : "high");
      add_primary(name, [&, tracer, packets] { tracer->closest(primary, hits, packets); });
      add_shadow(name, [&, tracer, packets] { tracer->any(shadow, occluded, packets); });
      add_bounce(name, [&, tracer, packets] { tracer->closest(bounce, bounce_hits, packets); });
      if (packets) add_sampled(name, [&, tracer, packets] { tracer->closest(sampled, sampled_hits, packets); });
    }
  }
  auto const is_asked_for = [&](std::string const& layout) {
    return options.layouts.find(layout) != std::string::npos;
  };
  struct Layout {
    std::string name;
    OpenClTracer& tracer;
  };
  for (auto& [name, tracer] :
       {Layout{"scalar", scalar_tracer}, Layout{"wide", wide_tracer}, Layout{"packet", packet_tracer}}) {
    if (!is_asked_for(name)) continue;
    add_primary(name, [&] { tracer.closest(primary, hits); });
    add_shadow(name, [&] { tracer.any(shadow, occluded); });
    if (name == "packet") {
      add_sampled(name, [&] { tracer.closest(sampled, sampled_hits); });
    } else {
      if (name == "wide") add_bounce(name, [&] { tracer.closest(bounce, bounce_hits, true); });
      add_bounce(name == "wide" ? "wide, one by one" : name, [&] { tracer.closest(bounce, bounce_hits, false); });
    }
  }

  std::vector<double> disagreement;
  for (Contestant& contestant : contestants) {
    contestant.run();  // also compiles
    disagreement.push_back(contestant.disagreement());
  }
  for (int i = 0; i < options.repetitions; ++i) {
    for (Contestant& contestant : contestants) {
      contestant.ms.push_back(options.processor_time ? processor_milliseconds(contestant.run, options.threads)
                                                     : milliseconds(contestant.run));
    }
  }
  std::string json;
  for (std::size_t i = 0; i < contestants.size(); ++i) {
    Contestant const& contestant = contestants[i];
    auto const peer = std::find_if(contestants.begin(), contestants.end(), [&](Contestant const& other) {
      return other.rays == contestant.rays &&
             other.name == (contestant.rays == "bounce" ? "Embree 1 medium" : "Embree 16 medium");
    });
    double const ms = median(contestant.ms);
    double const ratio = median(peer->ms) / ms;
    double const mrays = double(contestant.ray_count) / ms / 1e3;
    fmt::print("{:8} {:18} {:8.2f} ms {:8.1f} Mrays/s {:6.2f} x  disagree {:.6f} %\n", contestant.rays, contestant.name,
               ms, mrays, ratio, 100 * disagreement[i]);
    json += fmt::format(
        "{}\n    {{\"rays\": \"{}\", \"tracer\": \"{}\", \"ms\": {:.4f}, \"mrays_per_s\": {:.3f}, "
        "\"ratio\": {:.4f}, \"disagree\": {:.9f}}}",
        i == 0 ? "" : ",", contestant.rays, contestant.name, ms, mrays, ratio, disagreement[i]);
  }
  if (!options.json.empty()) {
    std::ofstream out(options.json);
    out << fmt::format(
        "{{\n  \"triangles\": {},\n  \"threads\": {},\n  \"build_ms\": {{\"embree_medium\": {:.3f}, \"embree_high\": "
        "{:.3f}, \"lichtraum\": {:.3f}}},\n  \"bytes_per_triangle\": {{\"embree_medium\": {:.2f}, \"embree_high\": "
        "{:.2f}, \"lichtraum\": {:.2f}}},\n  \"results\": [{}\n  ]\n}}\n",
        mesh.triangles.size(), options.threads, median(embree_build), embree_high->build_ms(), median(own_build),
        double(embree->device_bytes()) / triangles, double(embree_high->device_bytes()) / triangles,
        own_bytes / triangles, json);
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app{"Traversal against Embree: primary, shadow and diffuse-bounce rays, interleaved, medians"};
  app.add_option("MODEL", options.model, "a glTF binary with triangles")->required();
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
  app.add_option("--only", options.only, "some of primary, shadow, bounce, samples");
  app.add_option("--layouts", options.layouts, "some of scalar, wide, packet");
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
