#include "reference/ground.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "core/elementary.hpp"
#include "lichtraum/orbit.hpp"
#include "scene/unit_vector.hpp"

namespace lichtraum {
namespace {

using std::numbers::pi;

/// The irradiance from above, over pi: by the middles of a fine grid of directions.
Rgb light_on_level(ReferenceEnvironment const& environment, Vec3 const& up) {
  constexpr int rings = 512, sectors = 1024;
  Transform const world_from_level = orbit_rotation({0, 0}, up);
  Rgb sum(0);
  for (int ring = 0; ring < rings; ++ring) {
    double const theta = 0.5 * pi * (ring + 0.5) / rings, sine = sin_of(theta), cosine = cos_of(theta);
    for (int sector = 0; sector < sectors; ++sector) {
      double const phi = 2 * pi * (sector + 0.5) / sectors;
      Vec3 const direction(sine * cos_of(phi), cosine, sine * sin_of(phi));
      sum += sine * cosine * environment.radiance(world_from_level.vector(direction));
    }
  }
  return sum * (pi / rings / sectors);
}

/// What arrives on the ground from a light's disc, over what its middle would send: the mean over the disc of the
/// cosine, and of the fall-off.
double share_of_disc(Light const& light, double distance) {
  PointLight const* const lamp = light.get<PointLight>();
  if (!lamp || lamp->radius == 0) return 1;
  double const slant = std::hypot(1, lamp->radius / distance);
  return 2 / (slant + 1) / (lamp->falls_off ? slant : 1);
}

}  // namespace

ReferenceGround::ReferenceGround(ReferenceScene const& scene, ReferenceEnvironment const& environment, Ground kind)
    : kind_(std::isfinite(scene.lowest_point) ? kind : Ground::none), lights_(scene.lights) {
  if (kind_ == Ground::none) return;
  up_ = unit_vector(scene.up);
  height_ = scene.lowest_point;
  from_afar_ = environment ? light_on_level(environment, up_) : scene.ambient;
}

double ReferenceGround::distance(Ray const& ray) const {
  double const height = glm::dot(up_, ray.origin) - height_, fall = -glm::dot(up_, ray.direction);
  return height > 0 && fall > 0 ? height / fall : std::numeric_limits<double>::infinity();
}

Rgb ReferenceGround::open_radiance(Vec3 const& position) const {
  Rgb sum = from_afar_;
  for (Light const& light : lights_) {
    Vec3 const way = light.way_from(position);
    double const cosine = glm::dot(up_, glm::normalize(way));
    if (cosine > 0) sum += cosine * share_of_disc(light, glm::length(way)) * light.arriving_at(position);
  }
  return sum;
}

ReferenceScatteringPoint ReferenceGround::black_point(Ray const& ray, double t) const {
  ReferenceScatteringPoint point{};
  point.position = ray.origin + t * ray.direction;
  point.position += (height_ - glm::dot(up_, point.position)) * up_;
  point.set_normals(up_);
  point.to_viewer = -ray.direction;
  point.offset = reference_ray_epsilon * glm::length(point.position);
  return point;
}

ReferenceScatteringPoint ReferenceGround::matt_point(Ray const& ray, double t, Rgb const& shown) const {
  ReferenceScatteringPoint point = black_point(ray, t);
  Rgb const open = open_radiance(point.position);
  for (int c = 0; c < 3; ++c) {
    bool const is_lit = open[c] > 0;
    point.bsdf.diffuse[c] = is_lit ? shown[c] / open[c] : 0;
    point.emission[c] = is_lit ? 0 : shown[c];
  }
  return point;
}

ReferenceScatteringPoint ReferenceGround::glossy_point(Ray const& ray, double t) const {
  ReferenceScatteringPoint point = black_point(ray, t);
  point.bsdf.f0 = Rgb(0.04);
  point.bsdf.f90 = Rgb(1);
  point.bsdf.alpha = 0.03;
  return point;
}

}  // namespace lichtraum
