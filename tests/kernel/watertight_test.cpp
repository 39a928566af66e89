#include <map>

#include "random_scene.hpp"
#include "support/catch.hpp"
#include "support/skip.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

namespace {

/// A closed mesh that the origin lies in.
struct ClosedMesh {
  std::vector<Vec3> vertices;
  std::vector<std::array<std::size_t, 3>> triangles;

  static ClosedMesh cube() {
    ClosedMesh mesh;
    for (int i = 0; i < 8; ++i) mesh.vertices.push_back({i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1});
    mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return mesh;
  }

  /// Each triangle becomes four, on the unit sphere.
  static ClosedMesh icosphere(int subdivisions) {
    double const g = (1 + std::sqrt(5.)) / 2;
    ClosedMesh mesh;
    mesh.vertices = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                     {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
    mesh.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                      {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                      {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
    for (int s = 0; s < subdivisions; ++s) {
      std::map<std::pair<std::size_t, std::size_t>, std::size_t> middles;
      auto const middle = [&](std::size_t a, std::size_t b) {
        auto const [found, is_new] = middles.emplace(std::minmax(a, b), mesh.vertices.size());
        if (is_new) mesh.vertices.push_back(0.5 * (mesh.vertices[a] + mesh.vertices[b]));
        return found->second;
      };
      decltype(mesh.triangles) finer;
      for (auto const& [a, b, c] : mesh.triangles) {
        std::size_t const ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
        finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
      }
      mesh.triangles = finer;
    }
    for (auto& v : mesh.vertices) v = glm::normalize(v);
    return mesh;
  }

  void map(Affine const& affine) {
    for (auto& v : vertices) {
      v = affine.point(v);
      v = Vec3(float(v.x), float(v.y), float(v.z));
    }
  }
};

/// Sends rays from inside a closed mesh to its vertices and edges, in portions: how many find no triangle at all.
std::size_t count_leaks(ProbeProgram const& program, ClosedMesh const& mesh, Vec3 const& center, double radius,
                        std::size_t count, std::uint64_t seed) {
  SceneArrays scene;
  for (auto const& [a, b, c] : mesh.triangles) {
    scene.add(make_triangle(mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]));
  }
  scene.close_object();
  Random random(seed);
  std::size_t leaks = 0;
  for (std::size_t done = 0; done < count;) {
    std::size_t const portion = std::min<std::size_t>(count - done, 250000);
    std::vector<ProbeRay> rays(portion);
    for (std::size_t i = 0; i < portion; ++i) {
      auto const& corners = mesh.triangles[random.index(mesh.triangles.size())];
      std::size_t const first = random.index(3);
      Vec3 const a = mesh.vertices[corners[first]], b = mesh.vertices[corners[(first + 1) % 3]];
      double const along = i % 4 == 0 ? 0 : i % 4 == 1 ? 0.5 : random.uniform();
      Vec3 const origin = i % 8 == 7 ? center : center + random.in_cube(0.4 * radius);
      rays[i].origin = to_float4(origin);
      rays[i].direction =
          to_float4((a + along * (b - a) - to_vec3(rays[i].origin)) * (i % 3 == 0 ? 1 : random.uniform(0.01, 5)));
    }
    std::vector<float> const t_max(portion, float_infinity);
    std::vector<device::uint> found(portion);
    program.run("probe_trace_any", portion, scene.arguments({in(rays), in(t_max), out(found)}));
    for (auto f : found) leaks += f == 0;
    done += portion;
  }
  return leaks;
}

}  // namespace

TEST_CASE("No ray slips through the edges and vertices of a closed mesh", "[kernel]") {
  NEEDS_OPENCL_DEVICE();
  ProbeProgram const program("traversal.cl");
  Random random(50);
  std::size_t const count = scaled_count(400000);
  struct Place {
    double radius;
    Vec3 center;
  };
  for (auto const& place :
       {Place{1, Vec3(0)}, Place{1e-3, Vec3(0)}, Place{1e6, Vec3(0)}, Place{100, Vec3(1e5, -1e5, 1e5)}}) {
    INFO("radius " << place.radius << " at " << place.center.x);
    Affine const turned{random.rotation() * place.radius, place.center};
    for (auto mesh : {ClosedMesh::cube(), ClosedMesh::icosphere(3)}) {
      mesh.map(turned);
      CHECK(count_leaks(program, mesh, place.center, place.radius, count, 51) == 0);
    }
    auto straight = ClosedMesh::cube();
    straight.map({Mat3(place.radius), place.center});
    CHECK(count_leaks(program, straight, place.center, place.radius, count, 52) == 0);
  }
}
