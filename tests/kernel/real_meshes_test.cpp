/// No ray slips through the closed surfaces among real models: LICHTRAUM_CORPUS/gltf, whose INDEX.tsv names class and
/// path of each.

#include <filesystem>
#include <fstream>
#include <iostream>
#include <set>
#include <sstream>

#include "cl/render_program.hpp"
#include "layout_probe.hpp"
#include "lichtraum/error.hpp"
#include "lichtraum/gltf.hpp"
#include "scene/flatten.hpp"
#include "support/catch.hpp"
#include "support/closed_mesh.hpp"
#include "support/skip.hpp"

using namespace lichtraum;
using namespace lichtraum::test;
namespace fs = std::filesystem;

namespace {

constexpr std::size_t largest_mesh = 60000;  // triangles: what is inside is found out by looking at all of them

/// Closed, and moved and scaled so that it fits the cube from -1 to 1. Its corners are floats.
struct RealMesh {
  std::string name;
  std::vector<Corners> triangles;

  /// Points that the surface winds around, and that it is `margin` away from.
  std::vector<Vec3> points_inside(Random& random, double margin, std::size_t count) const {
    std::vector<Vec3> found;
    for (int attempt = 0; attempt < 300 && found.size() < count; ++attempt) {
      // Between two corners: more often inside than what is anywhere in the cube.
      Vec3 const a = triangles[random.index(triangles.size())][0], b = triangles[random.index(triangles.size())][1];
      Vec3 const p = a + random.uniform(0.2, 0.8) * (b - a);
      if (is_clear(p, margin) && std::abs(winding_number(triangles, p)) > 0.5) found.push_back(p);
    }
    return found;
  }

 private:
  /// Whether every triangle's plane, or the box around it, is that far away.
  bool is_clear(Vec3 const& p, double margin) const {
    for (auto const& [a, b, c] : triangles) {
      Vec3 const low = glm::min(a, glm::min(b, c)), high = glm::max(a, glm::max(b, c));
      double const from_plane = std::abs(glm::dot(glm::normalize(glm::cross(b - a, c - a)), p - a));
      double const from_box = glm::length(glm::max(Vec3(0), glm::max(low - p, p - high)));
      if (std::max(from_plane, from_box) < margin) return false;
    }
    return true;
  }
};

Vec3 rounded(Vec3 const& p) { return {float(p.x), float(p.y), float(p.z)}; }

/// The closed parts of triangles with area: the others are never hit, and what needs them to be closed has a corner of
/// one triangle on the edge of another, where rounding leaves gaps.
std::vector<Corners> closed_parts_with_area(std::vector<Corners> triangles) {
  std::erase_if(triangles, [](Corners const& c) { return glm::cross(c[1] - c[0], c[2] - c[0]) == Vec3(0); });
  return closed_parts(triangles);
}

/// An object's, moved and scaled; nothing if it has none.
std::vector<Corners> closed_parts_of(FlatObject const& object) {
  std::vector<Corners> triangles;
  for (auto const& triangle : object.triangles) {
    triangles.push_back({to_vec3(triangle.vertices[0]), to_vec3(triangle.vertices[1]), to_vec3(triangle.vertices[2])});
  }
  triangles = closed_parts_with_area(std::move(triangles));
  Vec3 low(infinity), high(-infinity);
  for (Corners const& corners : triangles) {
    for (Vec3 const& p : corners) low = glm::min(low, p), high = glm::max(high, p);
  }
  double const half = 0.5 * max_abs(high - low);
  if (triangles.empty() || !(half > 0)) return {};
  for (Corners& corners : triangles) {
    for (Vec3& p : corners) p = rounded((p - 0.5 * (low + high)) / half);
  }
  return closed_parts_with_area(std::move(triangles));
}

/// Each once, as many models come in several encodings.
std::vector<RealMesh> closed_meshes(fs::path const& folder) {
  std::vector<RealMesh> meshes;
  std::set<std::pair<std::size_t, std::vector<double>>> known;
  std::ifstream index(folder / "INDEX.tsv");
  for (std::string line; std::getline(index, line);) {
    std::istringstream cells(line);
    std::string kind, path;
    std::getline(cells, kind, '\t');
    std::getline(cells, path, '\t');
    if (kind == "class" || kind == "malformed" || kind == "hostile") continue;
    try {
      FlatScene const scene = flatten(import_gltf(folder / path).scene.roots());
      for (FlatObject const& object : scene.objects) {
        if (object.triangles.size() > largest_mesh) continue;
        std::vector<Corners> triangles = closed_parts_of(object);
        if (triangles.empty()) continue;
        std::vector<double> beginning;  // of what tells meshes apart
        for (std::size_t i = 0; i < std::min<std::size_t>(4, triangles.size()); ++i) {
          for (Vec3 const& p : triangles[i]) beginning.insert(beginning.end(), {p.x, p.y, p.z});
        }
        if (!known.emplace(triangles.size(), beginning).second) continue;
        meshes.push_back({path, std::move(triangles)});
      }
    } catch (Error const&) {  // what loaders make of it is tested elsewhere
    }
  }
  return meshes;
}

/// Where a mesh of size 1 stands, and how near to its surface rays may begin without rounding carrying them through it.
struct Placement {
  Transform world_from_mesh;
  double margin;
  bool is_instance;
};

std::vector<Placement> placements() {
  std::vector<Placement> all{{Transform(), 0.01, false},
                             {Transform::translation(Vec3(1e3, -1e3, 1e3)), 0.01, false},
                             {Transform::translation(Vec3(-1e6, 3e5, 1e6)), 0.3, false}};
  for (Transform const& nasty : nasty_transforms()) all.push_back({nasty, 0.2, true});
  return all;
}

struct Tally {
  std::size_t rays = 0, leaks = 0, meshes = 0;
};

/// Rays from inside the mesh to its corners and edges, about as many in all of `layouts`.
void trace(RealMesh mesh, Placement const& placement, std::size_t rays_per_layout, Random& random, Tally& tally) {
  Transform const& map = placement.world_from_mesh;
  if (!placement.is_instance) {  // as it is stored there: far away, corners come to lie together
    for (Corners& corners : mesh.triangles) {
      for (Vec3& p : corners) p = rounded(map.point(p));
    }
    mesh.triangles = closed_parts_with_area(std::move(mesh.triangles));
    if (mesh.triangles.empty()) return;
  }
  std::vector<Vec3> origins;
  for (Vec3 const& p : mesh.points_inside(random, placement.margin, 4)) {
    origins.push_back(rounded(placement.is_instance ? map.point(p) : p));
  }
  if (origins.empty()) return;
  ++tally.meshes;
  FlatScene scene;
  scene.objects.resize(placement.is_instance ? 2 : 1);
  for (Corners const& c : mesh.triangles)
    scene.objects.back().triangles.push_back(tagged_triangle(c[0], c[1], c[2], 0));
  if (placement.is_instance) scene.instances.push_back({1, map});
  scene.materials = {std::make_shared<Material>()};
  for (Traversal const traversal : all_layouts) {
    LayoutProbe const probe(scene, traversal, RenderProgram{}.traversal_stack_size);
    std::size_t const leaks = count_misses(probe, rays_per_layout, [&](Rays& rays) {
      Vec3 const from = origins[random.index(origins.size())];
      std::size_t const near = random.index(mesh.triangles.size());
      rays.add_packet(from, [&] {
        Corners const& corners = mesh.triangles[(near + random.index(4)) % mesh.triangles.size()];
        std::size_t const first = random.index(3);
        double const along = random.index(3) == 0 ? 0 : random.uniform();
        Vec3 const p = corners[first] + along * (corners[(first + 1) % 3] - corners[first]);
        return (placement.is_instance ? map.point(p) : p) - from;
      });
    });
    INFO(mesh.name << ", layout " << int(traversal.layout) << ", " << leaks << " leaks");
    CHECK(leaks == 0);
    tally.leaks += leaks;
    tally.rays += rays_per_layout;
  }
}

Tally trace_all(fs::path const& folder, std::size_t rays_per_layout) {
  Tally tally;
  Random random(60);
  std::vector<RealMesh> const meshes = closed_meshes(folder);
  REQUIRE(meshes.size() > 50);
  auto const places = placements();
  for (std::size_t place = 0; place < places.size(); ++place) {
    INFO("placement " << place);
    std::size_t const before = tally.meshes;
    for (RealMesh const& mesh : meshes) trace(mesh, places[place], rays_per_layout, random, tally);
    CHECK(tally.meshes - before > 10);
  }
  std::cout << meshes.size() << " closed meshes, " << tally.meshes << " placed, " << tally.rays
            << " rays: " << tally.leaks << " leaks\n";
  return tally;
}

}  // namespace

TEST_CASE("no ray slips through closed real meshes", "[kernel][layouts][corpus]") {
  NEEDS_OPENCL_DEVICE();
  char const* const corpus = std::getenv("LICHTRAUM_CORPUS");
  if (!corpus) SKIP_TEST("LICHTRAUM_CORPUS does not name the folder of real models");
  CHECK(trace_all(fs::path(corpus) / "gltf", scaled_count(1 << 10)).leaks == 0);
}

TEST_CASE("none of 10^8 rays slips through closed real meshes", "[kernel][layouts][corpus][long][.]") {
  NEEDS_OPENCL_DEVICE();
  char const* const corpus = std::getenv("LICHTRAUM_CORPUS");
  if (!corpus) SKIP_TEST("LICHTRAUM_CORPUS does not name the folder of real models");
  CHECK(trace_all(fs::path(corpus) / "gltf", 1 << 15).leaks == 0);
}
