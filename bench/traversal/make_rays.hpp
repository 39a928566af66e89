#pragma once

#include "bench_rays.hpp"
#include "bench_scene.hpp"
#include "lichtraum/math.hpp"

namespace lichtraum::bench {

/// What a hit says about the surface: a point off it on the side that the ray came from, and its normal there.
struct SurfacePoint {
  bool hit = false;
  Vec3 position{0}, normal{0};
};

/// Where these rays, with these closest hits, have met the scene: one point a ray.
std::vector<SurfacePoint> surface_points(BenchScene const& scene, PrimaryRays const& rays,
                                         std::vector<RayHit> const& hits);
std::vector<SurfacePoint> surface_points(BenchScene const& scene, FreeRays const& rays,
                                         std::vector<RayHit> const& hits);

ShadowRays shadow_rays(std::vector<SurfacePoint> const& points, Vec3 const& light, PrimaryRays const& rays);

/// From the points that were hit, cosine-distributed about the normals, as a path goes on from a Lambertian surface; in
/// the order of the points, so that what has ended leaves no holes.
FreeRays bounce_rays(std::vector<SurfacePoint> const& points, unsigned seed);

}  // namespace lichtraum::bench
