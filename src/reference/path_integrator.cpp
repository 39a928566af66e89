#include "reference/path_integrator.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/elementary.hpp"
#include "core/largest_channel.hpp"
#include "core/luminance.hpp"
#include "core/square.hpp"
#include "reference/integrator.hpp"
#include "reference/scattering_point.hpp"

namespace lichtraum {
namespace {

using std::numbers::pi;

/// The roughness that caustics of lamps are drawn with, at least: else they are dots that no path finds twice.
constexpr double caustic_alpha = 0.4;

Vec3 uniform_direction(ReferenceRandom& random) {
  double const z = 1 - 2 * random.uniform();
  double const radius = std::sqrt(1 - z * z);
  double const angle = 2 * pi * random.uniform();
  return glm::normalize(Vec3(radius * cos_of(angle), radius * sin_of(angle), z));
}

/// The share of a light that gets to the ray's origin.
Rgb visibility(ReferenceScene const& scene, Ray const& ray, double t_max) {
  Rgb share(1);
  double t_min = 0;
  while (share != Rgb(0)) {
    Hit hit;
    hit.t = t_max;
    if (!find_closest(scene, ray, t_min, hit)) break;
    share *= find_scattering_point(ray, hit).straight();
    t_min = hit.t;
  }
  return share;
}

/// The light; where it has a radius, one at any point of the disc as which `point` sees it.
Light placed(Light const& light, Vec3 const& point, ReferenceRandom& random) {
  PointLight const* const lamp = light.get<PointLight>();
  if (!lamp || lamp->radius == 0 || lamp->position == point) return light;
  Vec3 const way = lamp->position - point;
  Vec3 const aside = std::abs(way.x) < std::abs(way.y) ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
  Vec3 const x = glm::normalize(glm::cross(way, aside)), y = glm::normalize(glm::cross(way, x));
  double const radius = lamp->radius * std::sqrt(random.uniform()), angle = 2 * pi * random.uniform();
  PointLight moved = *lamp;
  moved.position += radius * (cos_of(angle) * x + sin_of(angle) * y);
  return {light.name(), moved};
}

/// The solids that a path is in, as far as it has been seen to enter them: the last one, and the one before.
struct EnteredSolids {
  PbrModel const* inner = nullptr;
  PbrModel const* outer = nullptr;
};

/// In which light is that leaves a surface in this direction, where the path that met it was in `entered`.
EnteredSolids solids_towards(ReferenceScatteringPoint const& point, EnteredSolids const& entered,
                             Vec3 const& direction) {
  bool const crosses = point.solid && glm::dot(point.geometric_normal, direction) < 0;
  if (!crosses) return entered;
  if (point.from_outside) return {point.solid, entered.inner};
  return {entered.outer == point.solid ? entered.inner : entered.outer, nullptr};
}

double reflected_head_on(double ior) { return square((ior - 1) / (ior + 1)); }

/// Where the path has been in another body: the definition of refract_between_solids in kernels/integrators/solid.clh.
void refract_between_solids(ReferenceScatteringPoint& point, EnteredSolids const& entered) {
  if (!point.solid || !entered.inner) return;
  PbrModel const* const after = solids_towards(point, entered, -point.geometric_normal).inner;
  double const own = point.bsdf.ior;
  bool const is_left = !point.from_outside;
  double const inner = is_left && entered.inner != point.solid ? ior_in(*entered.inner) : own;
  double const outer = !is_left ? ior_in(*entered.inner) : after ? ior_in(*after) : 1;
  double const ratio = inner / outer;
  bool const is_same = std::abs(ratio - 1) < 1e-3;
  double const in_air = reflected_head_on(own), here = reflected_head_on(ratio);
  point.bsdf.f0 = in_air > 0 ? here / in_air * point.bsdf.f0 : here * point.bsdf.f90;
  point.bsdf.f0 = is_same ? Rgb(0) : glm::min(point.bsdf.f0, Rgb(1));
  if (is_same) point.bsdf.f90 = Rgb(0);
  point.bsdf.ior = is_same ? 1 : ratio;
}

/// What the surface reflects of lights that no ray would meet, of a path that was in `entered`.
Rgb light_of_lamps(ReferenceScene const& scene, ReferenceScatteringPoint const& point,
                   ReferenceScattering const& scattering, EnteredSolids const& entered, ReferenceRandom& random,
                   RayCounts& counts) {
  Rgb radiance(0);
  for (Light const& lamp : scene.lights) {
    Light const light = placed(lamp, point.position, random);
    Vec3 const way = light.way_from(point.position);
    if (way == Vec3(0)) continue;
    Vec3 const to_light = glm::normalize(way);
    // Brightness is what a white matt surface shows: pi times what arrives.
    Rgb const reflected =
        pi * light.arriving_at(point.position) * scattering.evaluate(to_light, ReferenceScattering::Lobes::all);
    if (reflected == Rgb(0) || !point.is_consistent_with_lamp(to_light)) continue;
    ++counts.shadow;
    double const t_max =
        light.position() ? glm::length(way) * (1 - reference_ray_epsilon) : std::numeric_limits<double>::infinity();
    PbrModel const* const solid = solids_towards(point, entered, to_light).inner;
    double const way_in_solid = std::min(t_max, std::numeric_limits<double>::max());
    Rgb const left = solid ? attenuation(*solid, way_in_solid) : Rgb(1);
    radiance += light_share(solid) * left * reflected * visibility(scene, point.leave_to_lamp(to_light), t_max);
  }
  return radiance;
}

/// How a path goes on.
struct Continuation {
  Vec3 direction{0};
  Rgb weight{0};
  bool is_mirror_or_glass = false;
  bool is_smooth = false;
};

/// A smooth ray's direction. Where smooth normals send it to the wrong side of the surface, the surface itself mirrors
/// it, to the side that was meant; but it may enter and leave solids as it is.
Vec3 corrected(Vec3 const& direction, ReferenceScatteringPoint const& point) {
  if (point.solid || point.is_consistent(direction)) return direction;
  return glm::normalize(direction - 2 * glm::dot(direction, point.geometric_normal) * point.geometric_normal);
}

/// One of the smooth rays, or a uniform direction for all that is spread, each with the same probability.
Continuation choose_continuation(ReferenceScattering const& scattering, ReferenceScatteringPoint const& point,
                                 ReferenceRandom& random) {
  auto const rays = scattering.smooth_rays();
  std::size_t const choices = rays.size() + (scattering.has_spread() ? 1 : 0);
  if (choices == 0) return {};
  auto const choice = std::size_t(random.uniform() * double(choices));
  if (choice < rays.size()) {
    auto const& [direction, weight, is_mirror_or_glass] = rays[choice];
    return {corrected(direction, point), double(choices) * weight, is_mirror_or_glass, true};
  }
  Vec3 direction = uniform_direction(random);
  double solid_angle = 4 * pi;
  if (!scattering.transmits()) {
    solid_angle = 2 * pi;
    if (glm::dot(direction, point.normal) < 0) direction = -direction;
  }
  Rgb const reflected = scattering.evaluate(direction, ReferenceScattering::Lobes::spread);
  return {direction, double(choices) * solid_angle * reflected};
}

struct FollowedPath : PathSample {
  bool begins_on_ground = false;
};

/// The same as trace_path, where the ground is a surface among others.
FollowedPath follow_path(ReferenceScene const& scene, ReferenceEnvironment const& environment,
                         ReferenceGround const& ground, Ray ray, Rgb const& background, RenderRequest const& request,
                         ReferenceRandom& random, RayCounts& counts) {
  FollowedPath sample;
  auto const add = [&](Rgb const& radiance, bool is_indirect) {
    double const largest = is_indirect ? largest_channel(radiance) : 0;
    sample.radiance += largest > request.max_indirect ? radiance * (request.max_indirect / largest) : radiance;
  };
  Rgb throughput(1);
  bool const sees_environment =
      environment && request.background && request.background->kind == Background::Kind::environment;
  Rgb thrown_share(1);           // of what it throws on the ground, that reflects no more of it than white does
  bool mirrored = false;         // in the ground's gloss
  bool sees_background = false;  // by a mirror or through glass
  bool is_in_window = true;      // the camera sees what is here, with nothing but thin walls before it
  bool is_spread = false;        // by a surface that is not smooth
  EnteredSolids entered;
  int depth = 0;
  for (bool is_first_ray = true;; is_first_ray = false) {
    ++(is_first_ray ? counts.camera : counts.secondary);
    Hit hit;
    bool const is_hit = find_closest(scene, ray, 0, hit);
    bool const is_ground = depth == 0 && ground && ground.distance(ray) < hit.t;
    bool const is_in_gloss =
        mirrored && depth == 1;  // where the open ground mirrors its background, and counts nothing
    Rgb const in_gloss = sees_environment ? environment.radiance(ray.direction) : background;
    if (!is_hit && !is_ground) {
      if (is_in_gloss) return sample;
      Rgb const from_afar = environment       ? environment.radiance(ray.direction)
                            : sees_background ? scene.background
                                              : scene.ambient;
      bool const is_behind_wall = is_in_window && depth > 0 && !sees_environment;
      if (is_behind_wall && request.planes.has(FilmPlane::alpha)) {
        sample.surface.alpha -= luminance(throughput);
        return sample;
      }
      add(throughput * (depth == 0 || is_behind_wall ? background : from_afar), depth > 1);
      if (depth == 0) sample.surface.albedo = glm::min(throughput * background, Rgb(1));
      return sample;
    }
    counts.camera_hits += is_first_ray && !is_ground;
    if (is_ground) {
      sample.begins_on_ground = true;
      sample.surface.albedo = glm::min(throughput * background, Rgb(1));
      mirrored = ground.is_glossy() && random.uniform() < 0.5;
      if (ground.is_glossy()) throughput *= 2.0;
    }
    ReferenceScatteringPoint point = mirrored && is_ground ? ground.glossy_point(ray, ground.distance(ray))
                                     : is_ground           ? ground.matt_point(ray, ground.distance(ray), background)
                                                           : find_scattering_point(ray, hit);
    if (entered.inner) throughput *= attenuation(*entered.inner, hit.t);
    bool const is_hidden_back = depth == 0 && !point.from_outside && !point.shows_back;
    if (is_hidden_back) {
      ray = {point.below(), ray.direction};
      continue;
    }
    double const scatters = point.chance_to_scatter();
    if (random.uniform() >= scatters) {
      Rgb const weight = point.straight() / (1 - scatters);
      if (is_in_gloss) add((weight - 1.0) * throughput * in_gloss, false);
      throughput *= weight;
      ray = {point.below(), ray.direction};
      continue;
    }
    if (depth == 1) throughput *= thrown_share;
    if (is_in_gloss) add(-throughput * in_gloss, false);
    throughput /= 1 - point.chance_to_pass;
    if (depth == 0 && !is_ground) sample.surface = {1, throughput * point.albedo(), point.normal};
    if (!entered.inner && point.solid && !point.from_outside) throughput *= attenuation(*point.solid, hit.t);
    add(throughput * light_share(entered.inner) * point.emission, depth > 1);
    refract_between_solids(point, entered);
    if (depth == request.max_depth) return sample;
    if (is_ground) thrown_share = Rgb(1) / glm::max(point.bsdf.diffuse, Rgb(1));
    auto const scattering = point.scattering();
    bool const is_gloss = mirrored && is_ground;
    if (!is_gloss) {
      auto const to_lamps = is_spread ? scattering.blurred(caustic_alpha) : scattering;
      add(throughput * light_of_lamps(scene, point, to_lamps, entered, random, counts), depth > 0);
    }
    auto const next = choose_continuation(scattering, point, random);
    throughput *= next.weight;
    if (throughput == Rgb(0) || !(next.is_smooth || point.is_consistent(next.direction))) return sample;
    ray = point.leave(next.direction);
    entered = solids_towards(point, entered, next.direction);
    sees_background = next.is_mirror_or_glass;
    bool const passes_wall =
        !point.solid && point.bsdf.transmitted != Rgb(0) && glm::dot(point.geometric_normal, next.direction) < 0;
    is_in_window = is_in_window && passes_wall;
    is_spread = is_spread || !next.is_smooth;
    ++depth;
  }
}

}  // namespace

PathSample trace_path(ReferenceScene const& scene, ReferenceEnvironment const& environment,
                      ReferenceGround const& ground, Ray const& ray, Rgb const& background,
                      RenderRequest const& request, ReferenceRandom& random, RayCounts& counts) {
  bool const has_alpha = request.planes.has(FilmPlane::alpha);
  FollowedPath const path =
      follow_path(scene, environment, ground, ray, has_alpha ? Rgb(1) : background, request, random, counts);
  if (!has_alpha) return path;
  if (!path.begins_on_ground) {
    PathSample sample = path;
    if (sample.surface.alpha == 0) sample.surface.albedo = Rgb(0);  // what is behind it is somebody else's
    return sample;
  }
  // Whatever is behind it, the ground covers as much of that as it is darker than in the open.
  PathSample sample;
  sample.surface.alpha = 1 - luminance(path.radiance);
  return sample;
}

}  // namespace lichtraum
