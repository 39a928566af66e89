#include "render/reference_integrator.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "scene/unit_vector.hpp"
#include "shared/frame.h"

namespace lichtraum {
namespace {

/// How far, relative to the coordinates that went into it, a computed hit point may lie off its surface. A double has
/// 16 digits; the others are for cancellation, as where a small scene stands on a sphere of a million units.
constexpr double ray_epsilon = 1e-9;

double largest_coordinate(Vec3 const& p) { return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}); }

/// A point of a surface, as seen by the ray that found it.
struct SurfacePoint {
  Material const& material;
  Vec3 position;
  Vec3 normal;        // unit length, on the viewer's side
  Vec3 to_viewer;     // unit length
  bool from_outside;  // the viewer is on the side that the geometric normal points to
  double offset;      // rays start this far off the surface, so as not to hit it again

  Vec3 above() const { return position + offset * normal; }
  Vec3 below() const { return position - offset * normal; }
};

Material const& material_of(Shape const& shape) {
  static Material const matt_grey;
  return shape.material() ? *shape.material() : matt_grey;
}

SurfacePoint surface_point(Ray const& ray, Hit const& hit) {
  bool const from_outside = glm::dot(hit.normal, ray.direction) < 0;
  Vec3 const position = ray.at(hit.t);
  double const size = std::max(largest_coordinate(position), largest_coordinate(ray.origin));
  return {material_of(*hit.shape), position,     from_outside ? hit.normal : -hit.normal,
          -ray.direction,          from_outside, ray_epsilon * size};
}

bool find_closest(ReferenceScene const& scene, Ray const& ray, double t_min, Hit& hit) {
  bool found = false;
  for (auto const& root : scene.roots) found |= root->closest_hit(ray, t_min, hit);
  return found;
}

/// The share of a light that arrives: the product of `transmit` over the surfaces strictly between the point and it.
/// Surfaces at the same place count as one, as they do for camera rays.
double visibility(ReferenceScene const& scene, Vec3 const& from, Vec3 const& light) {
  Ray const ray{from, light - from};
  double share = 1;
  double t_min = 0;
  while (share > 0) {
    Hit hit;
    hit.t = 1 - ray_epsilon;
    if (!find_closest(scene, ray, t_min, hit)) break;
    share *= material_of(*hit.shape).transmit();
    t_min = hit.t;
  }
  return share;
}

/// What the surface shows by itself: emission, ambient, diffuse and specular term. A light that could not add anything
/// costs no shadow ray.
Rgb local_radiance(ReferenceScene const& scene, SurfacePoint const& point, RayCounts& counts) {
  Material const& material = point.material;
  double const matt_share = 1 - material.reflect() - material.transmit();
  Rgb radiance = material.emission() + matt_share * material.ka() * scene.ambient;
  for (Light const& light : scene.point_lights) {
    Vec3 const towards_light = light.position() - point.position;
    if (towards_light == Vec3(0)) continue;
    Vec3 const to_light = unit_vector(towards_light);
    double const cosine = glm::dot(point.normal, to_light);
    if (!(cosine > 0)) continue;
    Vec3 const mirrored_light = 2 * cosine * point.normal - to_light;
    double const gloss = std::pow(std::max(0.0, glm::dot(mirrored_light, point.to_viewer)), material.m());
    Rgb const reflected = light.ld() * (matt_share * cosine * material.kd() + gloss * material.ks());
    if (reflected == Rgb(0)) continue;
    ++counts.shadow;
    radiance += visibility(scene, point.above(), light.position()) * reflected;
  }
  return radiance;
}

/// A ray that is still to be traced, and how much of what it sees counts.
struct PendingRay {
  Ray ray;
  double weight;
  int depth;  // mirrors and glass surfaces before it
};

/// Adds the mirror ray and the refracted ray of a surface to `pending`.
void follow(SurfacePoint const& point, double weight, int depth, std::vector<PendingRay>& pending) {
  Material const& material = point.material;
  Vec3 const incoming = -point.to_viewer;
  double const cosine = glm::dot(point.normal, point.to_viewer);
  double mirror_share = material.reflect();
  double refracted_share = material.transmit();

  // Snell's law in vectors (Heckbert and Hanrahan 1984). Where the root does not exist all is reflected.
  double const eta = point.from_outside ? 1 / material.ior() : material.ior();
  double const square = 1 - eta * eta * (1 - cosine * cosine);
  if (square < 0) {
    mirror_share += refracted_share;
    refracted_share = 0;
  }
  auto const push = [&](double share, Vec3 const& origin, Vec3 const& direction) {
    if (share == 0 || weight * share < double(MIN_RAY_WEIGHT)) return;
    pending.push_back({{origin, unit_vector(direction)}, weight * share, depth + 1});
  };
  push(mirror_share, point.above(), incoming + 2 * cosine * point.normal);
  if (refracted_share > 0) {
    push(refracted_share, point.below(), eta * incoming + (eta * cosine - std::sqrt(square)) * point.normal);
  }
}

}  // namespace

Rgb trace_radiance(ReferenceScene const& scene, Ray const& camera_ray, int max_depth, RayCounts& counts) {
  Rgb radiance(0);
  ++counts.camera;
  std::vector<PendingRay> pending{{camera_ray, 1, 0}};
  while (!pending.empty()) {
    auto const [ray, weight, depth] = pending.back();
    pending.pop_back();
    if (depth > 0) ++counts.secondary;
    Hit hit;
    if (!find_closest(scene, ray, 0, hit)) {
      radiance += weight * scene.background;
      continue;
    }
    if (depth == 0) ++counts.camera_hits;
    SurfacePoint const point = surface_point(ray, hit);
    radiance += weight * local_radiance(scene, point, counts);
    if (depth < max_depth) follow(point, weight, depth, pending);
  }
  return radiance;
}

}  // namespace lichtraum
