/// Points of textured meshes, in every layout, against the reference renderer's: what shading sees, and what lets light
/// through.

#include "reference.hpp"
#include "reference/point.hpp"
#include "scene/flatten.hpp"
#include "scene_arguments.hpp"
#include "support/catch.hpp"
#include "support/skip.hpp"
#include "support/textured_meshes.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

namespace {

constexpr std::size_t packet_size = 64;

struct Rays {
  std::vector<float4> origins, directions;

  /// Packets of one origin each, before and behind the meshes; `t` 1 is on the other side.
  explicit Rays(std::size_t packets) {
    Random random(80);
    for (std::size_t i = 0; i < packets; ++i) {
      Vec3 const origin = Vec3(0, 0, i % 4 == 0 ? -1.5 : 8) + random.in_cube(1);
      for (std::size_t k = 0; k < packet_size; ++k) {
        origins.push_back(to_float4(origin));
        Vec3 const target(random.uniform(-5, 5), random.uniform(-2.5, 2.5), random.uniform(-0.6, 0.6));
        directions.push_back(to_float4(i % 4 == 0 ? target - origin : 1.1 * (target - origin), 1));
      }
    }
  }
  std::size_t size() const { return origins.size(); }
  Ray operator[](std::size_t i) const { return {to_vec3(origins[i]), to_vec3(directions[i])}; }
};

struct Layout {
  SceneBuffers buffers;
  std::string options;
  Layout(Scene const& scene, Traversal traversal)
      : buffers(compile_scene(flatten(scene.roots()), scene.lights, traversal.layout)),
        options(scene_options(buffers, traversal)) {}
  void run(std::string const& file, std::string const& kernel, std::size_t count, Rays const& rays,
           std::vector<ProbeArgument> const& more, std::size_t local = 1) const {
    auto arguments = scene_arguments(buffers);
    arguments.insert(arguments.end(), {in(rays.origins), in(rays.directions)});
    arguments.insert(arguments.end(), more.begin(), more.end());
    ProbeProgram(file, options).run(kernel, count, arguments, 1, local);
  }
};

/// Oclgrind interprets the scalar one only: see tests/CMakeLists.txt.
std::vector<Traversal> single_ray_layouts() {
  if (scaled_count(1000) < 1000) return {Traversal::scalar};
  return {Traversal::scalar, Traversal::wide};
}

bool find_next(Scene const& scene, Ray const& ray, double t_min, Hit& hit) {
  bool found = false;
  for (auto const& root : scene.roots()) found = root->closest_hit(ray, t_min, hit) || found;
  return found;
}

/// The first hit that is there.
bool find_first(Scene const& scene, Ray const& ray, Hit& hit) {
  double t_min = 0;
  for (;;) {
    hit = {};
    if (!find_next(scene, ray, t_min, hit)) return false;
    if (!is_absent(hit)) return true;
    t_min = hit.t;
  }
}

Vec3 coefficient(std::vector<float4> const& all, std::size_t i, std::size_t k) { return to_vec3(all[4 * i + k]); }

}  // namespace

TEST_CASE("Textures, normals and colours give a point the same coefficients on the device", "[kernel]") {
  NEEDS_OPENCL_DEVICE();
  Scene const scene = make_textured_scene();
  Rays rays(scaled_count(400) + 1);
  std::size_t const n = rays.size();
  for (float4& d : rays.directions) d = to_float4(glm::normalize(to_vec3(d)), 1);
  for (Traversal const traversal : single_ray_layouts()) {
    std::vector<float4> positions(n), normals(n), shading_normals(n), coefficients(4 * n);
    Layout(scene, traversal)
        .run("points.cl", "probe_points", n, rays,
             {out(positions), out(normals), out(shading_normals), out(coefficients)});
    std::size_t hits = 0, bent = 0, other = 0, wrong_normal = 0, wrong_color = 0, wrong_share = 0;
    for (std::size_t i = 0; i < n; ++i) {
      Hit hit;
      bool const found = find_first(scene, rays[i], hit);
      if (found != std::isfinite(positions[i].w) || (found && std::abs(hit.t - positions[i].w) > 1e-4)) {
        ++other;  // at edges of triangles and masks, rounding decides
        continue;
      }
      if (!found) continue;
      ++hits;
      ReferencePoint const point = find_reference_point(rays[i], hit);
      bent += glm::dot(point.normal, point.geometric_normal) < 1;
      wrong_normal += !(max_abs(to_vec3(normals[i]) - point.geometric_normal) < 1e-4 &&
                        max_abs(to_vec3(shading_normals[i]) - point.normal) < 2e-3);
      PhongModel const& p = point.phong;
      wrong_color += !(max_abs(coefficient(coefficients, i, 0) - p.ka) < 2e-3 &&
                       max_abs(coefficient(coefficients, i, 1) - p.kd) < 2e-3 &&
                       max_abs(coefficient(coefficients, i, 2) - p.ks) < 5e-3 &&
                       max_abs(coefficient(coefficients, i, 3) - p.emission) < 2e-3);
      wrong_share += !(std::abs(coefficients[4 * i].w - p.m) < 1e-2 * (1 + p.m) &&
                       std::abs(coefficients[4 * i + 1].w - p.reflect) < 2e-3 &&
                       std::abs(coefficients[4 * i + 2].w - p.transmit) < 2e-3 &&
                       std::abs(coefficients[4 * i + 3].w - p.ior) < 1e-6);
    }
    INFO("layout " << int(traversal.layout) << ": " << hits << " hits, " << bent << " bent");
    if (n > 10000) CHECK(hits > n / 2);
    if (n > 10000) CHECK(bent > n / 10);
    CHECK(other <= n / 500);
    CHECK(wrong_normal <= n / 2000);
    CHECK(wrong_color <= n / 2000);
    CHECK(wrong_share <= n / 2000);
  }
}

TEST_CASE("Masks and blends let shadow rays through as far as the reference does", "[kernel]") {
  NEEDS_OPENCL_DEVICE();
  Scene const scene = make_textured_scene();
  Rays const rays(scaled_count(300) + 1);
  std::size_t const n = rays.size();
  for (Traversal const traversal : single_ray_layouts()) {
    std::vector<float> visibility(n);
    std::vector<device::uint> any(n);
    Layout(scene, traversal).run("points.cl", "probe_visibility", n, rays, {out(visibility), out(any)});
    std::size_t wrong = 0, partial = 0, cut = 0;
    for (std::size_t i = 0; i < n; ++i) {
      double expected = 1, t_min = 0;
      bool is_any = false;
      for (;;) {
        Hit hit;
        hit.t = 1;
        if (!find_next(scene, rays[i], t_min, hit)) break;
        bool const absent = is_absent(hit);
        cut += absent;
        is_any = is_any || !absent;
        if (!absent) expected *= transmittance(hit);
        t_min = hit.t;
      }
      partial += expected > 0 && expected < 1;
      wrong += !(std::abs(expected - double(visibility[i])) < 2e-3 && (any[i] != 0) == is_any);
    }
    INFO("layout " << int(traversal.layout) << ": " << wrong << " of " << n);
    if (n > 10000) CHECK(partial > n / 50);
    if (n > 10000) CHECK(cut > n / 50);
    CHECK(wrong <= n / 500);
  }
}

TEST_CASE("packets see through masks and blends as single rays do", "[kernel][layouts]") {
  NEEDS_OPENCL_DEVICE();
  struct ProbeHit {
    float t;
    device::uint shape, instance, padding;
    bool operator==(ProbeHit const&) const = default;
  };
  Scene const scene = make_textured_scene();
  Rays const rays(scaled_count(1000) + 1);
  std::size_t const n = rays.size();
  std::vector<ProbeHit> hits[3];
  std::vector<device::uint> hidden[3];
  Traversal const layouts[] = {Traversal::scalar, Traversal::wide, Traversal::packet};
  for (std::size_t k = 0; k < 3; ++k) {
    bool const is_packet = layouts[k] == Traversal::packet;
    Layout const layout(scene, layouts[k]);
    hits[k].resize(n);
    hidden[k].resize(n);
    std::size_t const count = is_packet ? n / packet_size : n, local = is_packet ? 1 : 16;
    std::string const prefix = is_packet ? "probe_packet_" : "probe_";
    layout.run("layouts.cl", prefix + "closest", count, rays, {out(hits[k])}, local);
    layout.run("layouts.cl", prefix + "hidden", count, rays, {value(1.f), out(hidden[k])}, local);
  }
  std::size_t different = 0;
  for (std::size_t i = 0; i < n; ++i) {
    different += !(hits[1][i] == hits[0][i] && hits[2][i] == hits[0][i]);
    different += !(hidden[1][i] == hidden[0][i] && (hidden[2][i] & 1) == (hidden[0][i] & 1));
    // A packet leaves what may let light through to single rays.
    different += (hidden[2][i] & 2) != 0 && (hidden[0][i] & 2) == 0;
  }
  CHECK(different == 0);
}
