#pragma once

#include "bench_rays.hpp"
#include "lichtraum/transform.hpp"
#include "scene/flat_scene.hpp"

namespace lichtraum::bench {

/// What is traced: triangles of the world, and an object that instances place in it.
struct BenchScene {
  TriangleMesh world;
  TriangleMesh object;
  std::vector<Transform> placements;  ///< world_from_object

  std::size_t triangle_count() const { return world.triangles.size() + object.triangles.size(); }
  TriangleMesh const& mesh_of(RayHit const& hit) const { return hit.instance == RayHit::none ? world : object; }
  /// Where a corner of the triangle that was hit is in the world.
  Vec3 corner_of(RayHit const& hit, std::size_t corner) const;
};

/// A floor under the mesh, ten times as wide as that is high.
void add_floor(TriangleMesh& mesh);

/// `count` copies of the mesh on a floor, as close to each other as trees, each turned and scaled as chance has it, but
/// always the same way.
BenchScene plant_forest(TriangleMesh mesh, int count);

double diagonal(TriangleMesh const& mesh);

FlatScene flat_scene(BenchScene const& scene);

}  // namespace lichtraum::bench
