/// No ray slips through a closed mesh, in any layout of the tree.

#include <glm/gtc/constants.hpp>
#include <optional>

#include "layout_probe.hpp"
#include "support/catch.hpp"
#include "support/skip.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

namespace {

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
  return count_misses(probe, count, [&](Rays& rays) {
    Vec3 const origin = world_from_mesh.point(mesh.center + random.in_cube(0.3));
    Vec3 const from(float(origin.x), float(origin.y), float(origin.z));
    std::size_t const near = random.index(corners.size() / 4);
    rays.add_packet(from, [&] {
      std::size_t const quad = (near + random.index(3)) % (corners.size() / 4);
      Vec3 const a = corners[4 * quad + random.index(4)], b = corners[4 * quad + random.index(4)];
      double const s = random.index(3) == 0 ? 0 : random.uniform();
      return world_from_mesh.point(a + s * (b - a)) - from;
    });
  });
}

}  // namespace

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
