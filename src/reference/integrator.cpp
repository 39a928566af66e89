#include "reference/integrator.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "core/elementary.hpp"
#include "reference/point.hpp"
#include "scene/unit_vector.hpp"
#include "shared/ray_weight.h"

namespace lichtraum {

// Where nothing is in a surface, the ray goes on.
bool find_closest(ReferenceScene const& scene, Ray const& ray, double t_min, Hit& hit) {
  for (;;) {
    Hit nearest;
    nearest.t = hit.t;
    bool found = false;
    for (auto const& root : scene.roots) found |= root->closest_hit(ray, t_min, nearest);
    if (!found) return false;
    if (!is_absent(nearest)) {
      hit = nearest;
      return true;
    }
    t_min = nearest.t;
  }
}

namespace {

/// The share of a light that arrives: the product of what the surfaces strictly between the point and it let through.
/// Surfaces at the same place count as one, as they do for camera rays.
double visibility(ReferenceScene const& scene, Vec3 const& from, Light const& light) {
  bool const is_near = light.position() != nullptr;
  Ray const ray{from, light.way_from(from)};
  double share = 1;
  double t_min = 0;
  while (share > 0) {
    Hit hit;
    if (is_near) hit.t = 1 - reference_ray_epsilon;
    if (!find_closest(scene, ray, t_min, hit)) break;
    share *= transmittance(hit);
    t_min = hit.t;
  }
  return share;
}

/// What the surface shows by itself: emission, ambient, diffuse and specular term. A light that could not add anything
/// costs no shadow ray.
Rgb local_radiance(ReferenceScene const& scene, ReferencePoint const& point, RayCounts& counts) {
  PhongModel const& phong = point.phong;
  double const diffuse_weight = 1 - phong.reflect - phong.transmit;
  Rgb radiance = phong.emission + diffuse_weight * phong.ka * scene.ambient;
  for (Light const& light : scene.lights) {
    Vec3 const towards_light = light.way_from(point.position);
    if (towards_light == Vec3(0)) continue;
    Vec3 const to_light = unit_vector(towards_light);
    double const cosine = glm::dot(point.normal, to_light);
    if (!(cosine > 0)) continue;
    Vec3 const mirrored_light = 2 * cosine * point.normal - to_light;
    double const gloss = pow_of(std::max(0.0, glm::dot(mirrored_light, point.to_viewer)), phong.m);
    double const matt = diffuse_weight * cosine * bump_shadow(point.smooth_normal, point.normal, to_light);
    Rgb const reflected = light.arriving_at(point.position) * (matt * phong.kd + gloss * phong.ks);
    if (reflected == Rgb(0)) continue;
    // Where the triangle hides the light from itself, it counts whether the round body would be lit.
    bool const is_hidden = !(glm::dot(point.geometric_normal, to_light) > 0);
    if (is_hidden && !(glm::dot(point.round_normal, to_light) > 0)) continue;
    ++counts.shadow;
    radiance += visibility(scene, is_hidden ? point.above() + point.lift : point.above(), light) * reflected;
  }
  return radiance;
}

/// A ray that is still to be traced, and how much of what it sees counts.
struct PendingRay {
  Ray ray;
  double weight;
  int depth;  // mirrors and glass surfaces before it
};

/// Snell's law in vectors (Heckbert and Hanrahan 1984); nothing where all is reflected.
std::optional<Vec3> refracted(Vec3 const& incoming, Vec3 const& normal, double eta) {
  double const cosine = -glm::dot(normal, incoming);
  double const square = 1 - eta * eta * (1 - cosine * cosine);
  if (square < 0) return std::nullopt;
  return unit_vector(eta * incoming + (eta * cosine - std::sqrt(square)) * normal);
}

Vec3 mirrored(Vec3 const& incoming, Vec3 const& normal) {
  return unit_vector(incoming - 2 * glm::dot(normal, incoming) * normal);
}

/// Adds the mirror ray and the refracted ray of a surface to `pending`. Where a smooth or bumpy normal would lead to
/// the wrong side of the surface, the geometric one counts.
void follow(ReferencePoint const& point, double weight, int depth, std::vector<PendingRay>& pending) {
  Vec3 const incoming = -point.to_viewer;
  bool const is_usable = glm::dot(point.normal, point.to_viewer) > 0;
  double mirror_share = point.phong.reflect;
  double const eta = point.from_outside ? 1 / point.phong.ior : point.phong.ior;
  auto const push = [&](double share, Vec3 const& origin, Vec3 const& direction) {
    if (share == 0 || weight * share < double(MIN_RAY_WEIGHT)) return;
    pending.push_back({{origin, direction}, weight * share, depth + 1});
  };
  auto glass = refracted(incoming, is_usable ? point.normal : point.geometric_normal, eta);
  if (!glass || !(glm::dot(*glass, point.geometric_normal) < 0)) {
    glass = refracted(incoming, point.geometric_normal, eta);
  }
  if (!glass) mirror_share += point.phong.transmit;
  Vec3 mirror = mirrored(incoming, is_usable ? point.normal : point.geometric_normal);
  if (!(glm::dot(mirror, point.geometric_normal) > 0)) mirror = mirrored(incoming, point.geometric_normal);
  push(mirror_share, point.above(), mirror);
  if (glass) push(point.phong.transmit, point.below(), *glass);
}

}  // namespace

Rgb trace_radiance(ReferenceScene const& scene, Ray const& camera_ray, Rgb const& background, int max_depth,
                   RayCounts& counts) {
  Rgb radiance(0);
  ++counts.camera;
  std::vector<PendingRay> pending{{camera_ray, 1, 0}};
  while (!pending.empty()) {
    auto const [ray, weight, depth] = pending.back();
    pending.pop_back();
    if (depth > 0) ++counts.secondary;
    Hit hit;
    if (!find_closest(scene, ray, 0, hit)) {
      radiance += weight * (depth == 0 ? background : scene.background);
      continue;
    }
    if (depth == 0) ++counts.camera_hits;
    ReferencePoint const point = find_reference_point(ray, hit);
    radiance += weight * local_radiance(scene, point, counts);
    if (depth < max_depth) follow(point, weight, depth, pending);
  }
  return radiance;
}

}  // namespace lichtraum
