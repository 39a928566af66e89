/// Every layout of the tree finds what the scalar one finds, to the last bit, and no ray slips through a closed mesh.

#include <glm/gtc/constants.hpp>
#include <map>
#include <optional>

#include "compile/scene_buffers.hpp"
#include "layout_scenes.hpp"
#include "scene_arguments.hpp"
#include "support/catch.hpp"
#include "support/opencl_probe.hpp"
#include "support/skip.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

namespace {

struct ProbeHit {
  float t;
  device::uint shape;
  device::uint instance;
  device::uint padding;
};

/// One compiled scene in one layout, and the probes for it.
class LayoutProbe {
 public:
  LayoutProbe(FlatScene scene, Traversal traversal)
      : scene_(compile_scene(std::move(scene), {}, traversal.layout)),
        packets_(traversal.grouping == RayGrouping::packet),
        program_("layouts.cl", scene_options(scene_, traversal)) {}

  std::vector<ProbeHit> closest(Rays const& rays) const {
    std::vector<ProbeHit> hits(rays.size());
    run(packets_ ? "probe_packet_closest" : "probe_closest", rays, {out(hits)}, packets_ ? packet_size : 1);
    return hits;
  }
  /// Of the same rays, a few in turn.
  std::vector<ProbeHit> closest_in_turn(Rays const& rays) const {
    std::vector<ProbeHit> hits(rays.size());
    run("probe_stream_closest", rays, {out(hits)}, packet_size);
    return hits;
  }
  /// What gets through to t_max, 0..1.
  std::vector<float> visibility(Rays const& rays, float t_max) const {
    std::vector<float> visibility(rays.size());
    run("probe_visibility", rays, {value(t_max), out(visibility)}, 1);
    return visibility;
  }
  std::vector<float> visibility_in_turn(Rays const& rays, float t_max) const {
    std::vector<float> visibility(rays.size());
    run("probe_stream_visibility", rays, {value(t_max), out(visibility)}, packet_size);
    return visibility;
  }
  std::vector<device::uint> hidden(Rays const& rays, float t_max) const {
    std::vector<device::uint> hidden(rays.size());
    run(packets_ ? "probe_packet_hidden" : "probe_hidden", rays, {value(t_max), out(hidden)},
        packets_ ? packet_size : 1);
    return hidden;
  }
  SceneBuffers const& scene() const { return scene_; }

 private:
  void run(std::string const& kernel, Rays const& rays, std::vector<ProbeArgument> const& last,
           std::size_t rays_per_item) const {
    std::vector<ProbeArgument> arguments = scene_arguments(scene_);
    arguments.insert(arguments.end(), {in(rays.origins), in(rays.directions)});
    arguments.insert(arguments.end(), last.begin(), last.end());
    // Small groups: each work-item has much memory of its own.
    program_.run(kernel, rays.size() / rays_per_item, arguments, 1, rays_per_item > 1 ? 1 : 16, 1);
  }

  SceneBuffers scene_;
  bool packets_;
  ProbeProgram program_;
};

std::size_t count_different(std::vector<ProbeHit> const& a, std::vector<ProbeHit> const& b) {
  std::size_t different = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    bool const same = a[i].t == b[i].t && a[i].shape == b[i].shape && a[i].instance == b[i].instance;
    if (!same && different++ < 3) {
      UNSCOPED_INFO("ray " << i << ": t " << a[i].t << " and " << b[i].t << ", shape " << a[i].shape << " and "
                           << b[i].shape);
    }
  }
  return different;
}

/// A closed, bumpy surface around `center`: a sphere of 2 n^2 quads, split.
std::vector<Vec3> mesh_corners(Vec3 const& center, int n, BigVector<device::TrianglePrimitive>& triangles) {
  auto const corner = [&](int i, int j) {
    j = (j + 2 * n) % (2 * n);
    double const theta = glm::pi<double>() * i / n, phi = glm::pi<double>() * j / n;
    double const r = i == 0 || i == n ? 1 : 1 + 0.1 * std::sin(5. * theta) * std::cos(3. * phi);
    Vec3 const p = i == 0   ? Vec3(0, 0, 1)
                   : i == n ? Vec3(0, 0, -1)
                            : Vec3(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
    return center + r * p;
  };
  std::vector<Vec3> corners;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < 2 * n; ++j) {
      Vec3 const a = corner(i, j), b = corner(i, j + 1), c = corner(i + 1, j + 1), d = corner(i + 1, j);
      if (i > 0) triangles.push_back(tagged_triangle(a, b, c, device::uint(triangles.size())));
      if (i + 1 < n) triangles.push_back(tagged_triangle(a, c, d, device::uint(triangles.size())));
      for (Vec3 const& p : {a, b, c, d}) corners.push_back(p);
    }
  }
  return corners;
}

/// A closed mesh around `center`, there or as an instance.
struct PlacedMesh {
  Vec3 center = Vec3(0);
  std::optional<Transform> world_from_mesh = {};
};

/// How many of about `count` rays from within a closed mesh, aimed at its vertices and edges, meet nothing: where the
/// closest hit is looked for, and where any is.
std::size_t count_leaks(PlacedMesh const& mesh, std::size_t count, Traversal traversal) {
  FlatScene scene;
  scene.objects.resize(mesh.world_from_mesh ? 2 : 1);
  std::vector<Vec3> const corners = mesh_corners(mesh.center, 40, scene.objects.back().triangles);
  if (mesh.world_from_mesh) scene.instances.push_back({1, *mesh.world_from_mesh});
  scene.materials = {std::make_shared<Material>(), std::make_shared<Material>()};
  LayoutProbe const probe(std::move(scene), traversal);
  Transform const world_from_mesh = mesh.world_from_mesh.value_or(Transform());
  Random random(3);
  std::size_t leaks = 0;
  std::size_t const batch = std::max<std::size_t>(1, std::min<std::size_t>(count, 1 << 18) / packet_size);
  for (std::size_t done = 0; done < count; done += batch * packet_size) {
    Rays rays;
    for (std::size_t i = 0; i < batch; ++i) {
      Vec3 const origin = world_from_mesh.point(mesh.center + random.in_cube(0.3));
      Vec3 const from(float(origin.x), float(origin.y), float(origin.z));
      std::size_t const near = random.index(corners.size() / 4);
      rays.add_packet(from, [&] {
        std::size_t const quad = (near + random.index(3)) % (corners.size() / 4);
        Vec3 const a = corners[4 * quad + random.index(4)], b = corners[4 * quad + random.index(4)];
        double const s = random.index(3) == 0 ? 0 : random.uniform();
        return world_from_mesh.point(a + s * (b - a)) - from;
      });
    }
    for (ProbeHit const& hit : probe.closest(rays)) leaks += std::isfinite(hit.t) ? 0 : 1;
    for (device::uint const hidden : probe.hidden(rays, 1e6f)) leaks += hidden == 3 ? 0 : 1;
  }
  return leaks;
}

/// Scales from 1e-4 to 1e4, sheared, mirrored, flattened, and as far away as a million times their size.
std::vector<Transform> nasty_transforms() {
  Mat4 shear(1);
  shear[1][0] = 3;
  shear[2][1] = -2;
  Transform const sheared = Transform::from_matrix(shear);
  Transform const turned = Transform::rotation(37, Vec3(1, 2, 3));
  auto const moved = [](Vec3 const& offset, Transform const& t) { return Transform::translation(offset) * t; };
  return {turned * Transform::scaling(Vec3(1e-4)),
          turned * Transform::scaling(Vec3(1e4)),
          turned * Transform::scaling(Vec3(1, 1e-3, 20)),
          turned * sheared,
          Transform::scaling(Vec3(-1, 1, 1)) * turned,
          moved(Vec3(1e6, -3e5, 2e5), turned),
          moved(Vec3(70, 1, -100), turned * Transform::scaling(Vec3(1e-4))),
          moved(Vec3(1e9, 0, 1e8), sheared * Transform::scaling(Vec3(-1e4, 1e4, 1e4)))};
}

constexpr Traversal all_layouts[] = {Traversal::scalar, Traversal::wide, Traversal::packet};

}  // namespace

TEST_CASE("wide and packet find the scalar layout's hits, to the last bit", "[kernel][layouts]") {
  NEEDS_OPENCL_DEVICE();
  Rays const rays = mixed_rays(5, scaled_count(2000));
  auto const expected = LayoutProbe(mixed_scene(1), Traversal::scalar).closest(rays);
  std::size_t hits = 0;
  for (ProbeHit const& hit : expected) hits += std::isfinite(hit.t) ? 1 : 0;
  if (rays.size() > 10000) CHECK(hits > rays.size() / 4);
  if (rays.size() > 10000) CHECK(hits < rays.size());
  for (Traversal const traversal : {Traversal::wide, Traversal::packet}) {
    CHECK(count_different(LayoutProbe(mixed_scene(1), traversal).closest(rays), expected) == 0);
  }
}

TEST_CASE("wide and packet agree with the scalar layout on what is hidden, also by glass", "[kernel][layouts]") {
  NEEDS_OPENCL_DEVICE();
  Rays const rays = mixed_rays(6, scaled_count(1000));
  auto const expected = LayoutProbe(mixed_scene(2), Traversal::scalar).hidden(rays, 0.5f);
  std::map<device::uint, std::size_t> kinds;
  for (device::uint const h : expected) ++kinds[h];
  if (rays.size() > 10000) CHECK(kinds[0] > 100);
  if (rays.size() > 10000) CHECK(kinds[1] > 100);
  if (rays.size() > 10000) CHECK(kinds[3] > 100);
  for (Traversal const traversal : {Traversal::wide, Traversal::packet}) {
    CHECK((LayoutProbe(mixed_scene(2), traversal).hidden(rays, 0.5f) == expected));
  }
}

TEST_CASE("what a ray of a packet hits does not depend on the others", "[kernel][layouts]") {
  NEEDS_OPENCL_DEVICE();
  Rays rays = mixed_rays(7, scaled_count(200));
  LayoutProbe const probe(mixed_scene(1), Traversal::packet);
  auto const together = probe.closest(rays);
  Random random(1);
  for (float4& direction : rays.directions) direction.w = random.index(8) == 0 ? 1.f : 0.f;
  auto const few = probe.closest(rays);
  std::size_t different = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    bool const same = few[i].t == together[i].t && few[i].shape == together[i].shape;
    different += rays.directions[i].w > 0 && !same ? 1 : 0;
    if (rays.directions[i].w == 0) different += std::isfinite(few[i].t) ? 1 : 0;
  }
  CHECK(different == 0);
}

TEST_CASE("a ray hits among others in turn what it hits alone", "[kernel][layouts]") {
  NEEDS_OPENCL_DEVICE();
  Rays rays = mixed_rays(8, scaled_count(400));
  Random random(1);
  for (float4& direction : rays.directions) {
    if (random.index(50) == 0) direction = random.index(2) == 0 ? float4{} : float4{float_nan, 1, 1, 0};  // no rays
  }
  auto const expected = LayoutProbe(mixed_scene(1), Traversal::wide).closest(rays);
  for (Traversal const traversal : {Traversal::wide, Traversal::packet}) {
    CHECK(count_different(LayoutProbe(mixed_scene(1), traversal).closest_in_turn(rays), expected) == 0);
  }
}

TEST_CASE("as much light gets through to a ray among others in turn as alone", "[kernel][layouts]") {
  NEEDS_OPENCL_DEVICE();
  Rays const rays = mixed_rays(9, scaled_count(400));
  for (Traversal const traversal : {Traversal::wide, Traversal::packet}) {
    LayoutProbe const probe(mixed_scene(1), traversal);
    for (float const t_max : {0.3f, 20.f}) {
      auto const expected = LayoutProbe(mixed_scene(1), Traversal::wide).visibility(rays, t_max);
      CHECK(probe.visibility_in_turn(rays, t_max) == expected);
      if (rays.size() < 1000) continue;
      CHECK(std::ranges::count(expected, 0.f) > 10);
      CHECK(std::ranges::count(expected, 1.f) > 10);
      CHECK(std::ranges::count_if(expected, [](float share) { return share > 0 && share < 1; }) > 10);
    }
  }
}

TEST_CASE("no ray slips through a closed mesh", "[kernel][layouts]") {
  NEEDS_OPENCL_DEVICE();
  for (Traversal const traversal : all_layouts) {
    CHECK(count_leaks({}, scaled_count(1 << 19), traversal) == 0);
    CHECK(count_leaks({Vec3(1e5, -1e5, 1e5)}, scaled_count(1 << 17), traversal) == 0);
  }
}

TEST_CASE("no ray slips through an instance, however it is scaled, sheared and moved", "[kernel][layouts]") {
  NEEDS_OPENCL_DEVICE();
  for (Traversal const traversal : all_layouts) {
    auto const transforms = nasty_transforms();
    for (std::size_t i = 0; i < transforms.size(); ++i) {
      INFO("transform " << i);
      CHECK(count_leaks({Vec3(0), transforms[i]}, scaled_count(1 << 14), traversal) == 0);
    }
  }
}

TEST_CASE("none of 10^8 rays slips through a closed mesh", "[kernel][layouts][long][.]") {
  NEEDS_OPENCL_DEVICE();
  for (Traversal const traversal : {Traversal::wide, Traversal::packet}) {
    CHECK(count_leaks({}, 50'000'000, traversal) == 0);  // each is traced twice: for the closest hit, and for any
    CHECK(count_leaks({Vec3(1e5, -1e5, 1e5)}, 5'000'000, traversal) == 0);
  }
}
