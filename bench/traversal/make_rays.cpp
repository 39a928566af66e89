#include "make_rays.hpp"

#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <random>

namespace lichtraum::bench {
namespace {

Vec3 vec3(device::float4 const& v) { return {v.x, v.y, v.z}; }

struct WorldRay {
  Vec3 origin, direction;
};

std::vector<SurfacePoint> points_on(BenchScene const& scene, std::vector<RayHit> const& hits,
                                    std::function<WorldRay(std::size_t)> const& ray_of) {
  std::vector<SurfacePoint> points(hits.size());
  for (std::size_t i = 0; i < hits.size(); ++i) {
    if (!std::isfinite(hits[i].t)) continue;
    auto const [origin, direction] = ray_of(i);
    Vec3 const a = scene.corner_of(hits[i], 0), b = scene.corner_of(hits[i], 1), c = scene.corner_of(hits[i], 2);
    Vec3 normal = glm::cross(b - a, c - a);
    if (!(glm::length(normal) > 0)) continue;
    normal = glm::normalize(normal);
    if (glm::dot(normal, direction) > 0) normal = -normal;
    double const t = double(hits[i].t);
    points[i] = {true, origin + t * direction + 1e-4 * t * glm::length(direction) * normal, normal};
  }
  return points;
}

}  // namespace

std::vector<SurfacePoint> surface_points(BenchScene const& scene, PrimaryRays const& rays,
                                         std::vector<RayHit> const& hits) {
  return points_on(scene, hits, [&](std::size_t i) -> WorldRay {
    double const x = double(i % std::size_t(rays.width)) + 0.5, y = double(i / std::size_t(rays.width)) + 0.5;
    return {vec3(rays.camera.origin),
            vec3(rays.camera.corner) + x * vec3(rays.camera.step_x) + y * vec3(rays.camera.step_y)};
  });
}

std::vector<SurfacePoint> surface_points(BenchScene const& scene, FreeRays const& rays,
                                         std::vector<RayHit> const& hits) {
  return points_on(scene, hits, [&](std::size_t i) -> WorldRay {
    return {vec3(rays.origins[i]), vec3(rays.directions[i])};
  });
}

ShadowRays shadow_rays(std::vector<SurfacePoint> const& points, Vec3 const& light, PrimaryRays const& rays) {
  ShadowRays shadow{{}, {float(light.x), float(light.y), float(light.z), 0}, rays.width, rays.height};
  for (SurfacePoint const& p : points) {
    shadow.points.push_back({float(p.position.x), float(p.position.y), float(p.position.z), p.hit ? 1.0f : 0.0f});
  }
  return shadow;
}

FreeRays bounce_rays(std::vector<SurfacePoint> const& points, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  FreeRays rays;
  for (SurfacePoint const& p : points) {
    double const z = 2 * unit(random) - 1, phi = 2 * 3.14159265358979 * unit(random), r = std::sqrt(1 - z * z);
    Vec3 const direction = glm::normalize(p.normal + Vec3(r * std::cos(phi), r * std::sin(phi), z) * 0.999);
    if (!p.hit) continue;
    rays.origins.push_back({float(p.position.x), float(p.position.y), float(p.position.z), 0});
    rays.directions.push_back({float(direction.x), float(direction.y), float(direction.z), 0});
  }
  rays.count = rays.origins.size();
  std::size_t const padded =
      (rays.count + FreeRays::rays_per_item - 1) / FreeRays::rays_per_item * FreeRays::rays_per_item;
  rays.origins.resize(padded, {});
  rays.directions.resize(padded, {});
  return rays;
}

}  // namespace lichtraum::bench
