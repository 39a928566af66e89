#include "bench_scene.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>

namespace lichtraum::bench {
namespace {

struct Box {
  Vec3 low{1e30}, high{-1e30};
};

Box bounds_of(TriangleMesh const& mesh) {
  Box box;
  for (auto const& p : mesh.positions) {
    Vec3 const position(p[0], p[1], p[2]);
    box.low = glm::min(box.low, position);
    box.high = glm::max(box.high, position);
  }
  return box;
}

/// A horizontal square.
void add_square(TriangleMesh& mesh, Vec3 const& center, double half) {
  auto const first = std::uint32_t(mesh.positions.size());
  auto const x = float(center.x), y = float(center.y), z = float(center.z), h = float(half);
  mesh.positions.insert(mesh.positions.end(),
                        {{x - h, y, z - h}, {x - h, y, z + h}, {x + h, y, z + h}, {x + h, y, z - h}});
  mesh.triangles.insert(mesh.triangles.end(), {{first, first + 1, first + 2}, {first, first + 2, first + 3}});
}

FlatObject flat_object(TriangleMesh const& mesh) {
  FlatObject object;
  object.triangles.reserve(mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    device::TrianglePrimitive triangle{};
    for (int corner = 0; corner < 3; ++corner) {
      auto const& position = mesh.positions[mesh.triangles[i][std::size_t(corner)]];
      std::copy(position.begin(), position.end(), triangle.vertices[corner]);
    }
    triangle.tag = {0, device::uint(i)};
    object.triangles.push_back(triangle);
  }
  return object;
}

}  // namespace

Vec3 BenchScene::corner_of(RayHit const& hit, std::size_t corner) const {
  TriangleMesh const& mesh = mesh_of(hit);
  auto const& p = mesh.positions[mesh.triangles[hit.triangle][corner]];
  Vec3 const position(p[0], p[1], p[2]);
  return hit.instance == RayHit::none ? position : placements[hit.instance].point(position);
}

void add_floor(TriangleMesh& mesh) {
  auto const [low, high] = bounds_of(mesh);
  Vec3 const middle = 0.5 * (low + high);
  add_square(mesh, {middle.x, low.y, middle.z}, 5 * (high.y - low.y));
}

BenchScene plant_forest(TriangleMesh mesh, int count) {
  auto const [low, high] = bounds_of(mesh);
  Vec3 const foot(0.5 * (low.x + high.x), low.y, 0.5 * (low.z + high.z));
  double const width = std::max(high.x - low.x, high.z - low.z);
  int const side = int(std::ceil(std::sqrt(count)));
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(0, 1);
  BenchScene scene;
  for (int i = 0; i < count; ++i) {
    double const x = i % side - 0.5 * (side - 1) + 0.8 * (unit(random) - 0.5);
    double const z = i / side - 0.5 * (side - 1) + 0.8 * (unit(random) - 0.5);
    scene.placements.push_back(Transform::translation(foot + width * Vec3(x, 0, z)) *
                               Transform::rotation(360 * unit(random), {0, 1, 0}) *
                               Transform::scaling(Vec3(0.6 + 0.8 * unit(random))) * Transform::translation(-foot));
  }
  add_square(scene.world, foot, 0.5 * width * (side + 1));
  scene.object = std::move(mesh);
  return scene;
}

double diagonal(TriangleMesh const& mesh) {
  auto const [low, high] = bounds_of(mesh);
  return glm::length(high - low);
}

FlatScene flat_scene(BenchScene const& scene) {
  FlatScene flat;
  flat.objects.push_back(flat_object(scene.world));
  if (scene.placements.empty()) return flat;
  flat.objects.push_back(flat_object(scene.object));
  for (Transform const& placement : scene.placements) flat.instances.push_back({1, placement});
  return flat;
}

}  // namespace lichtraum::bench
