#include "render/frame_parameters.hpp"

#include <cmath>
#include <glm/geometric.hpp>

#include "film/check_request.hpp"
#include "scene/device_conversion.hpp"
#include "scene/unit_vector.hpp"

namespace lichtraum {
namespace {

device::ProjectiveCamera projective_camera(Camera const& camera, Resolution const& size) {
  Transform const& world_from_camera = camera.world_from_camera();
  bool const is_parallel = camera.is_orthographic();
  double const half_width = 0.5 * camera.width_at(1);
  double const half_height = half_width * size.height / size.width;
  return {device_float4(world_from_camera.point(Vec3(0))),
          device_float4(world_from_camera.vector({-half_width, half_height, is_parallel ? 0 : -1})),
          device_float4(world_from_camera.vector({2 * half_width / size.width, 0, 0})),
          device_float4(world_from_camera.vector({0, -2 * half_height / size.height, 0})),
          device_float4(world_from_camera.vector({0, 0, -1})),
          is_parallel,
          {}};
}

device::ThinLens thin_lens(Camera const& camera) {
  Transform const& world_from_camera = camera.world_from_camera();
  Lens const& lens = camera.lens();
  auto const axis = [&](Vec3 const& direction) {
    return device_float4(0.5 * lens.aperture * unit_vector(world_from_camera.vector(direction)));
  };
  return {axis({1, 0, 0}),
          axis({0, 1, 0}),
          float(lens.focus_distance / glm::length(world_from_camera.vector({0, 0, -1}))),
          lens.aperture > 0,
          {}};
}

/// Paths need samples that are even in all of their dimensions.
device::uint sampling_of(RenderRequest const& request) {
  if (request.sampling.pattern == Sampling::Pattern::grid) return SAMPLING_GRID;
  return request.integrator == Integrator::path ? SAMPLING_SOBOL : SAMPLING_SEEDED;
}

device::uint ground_of(Ground ground) {
  switch (ground) {
    case Ground::none:
      return GROUND_NONE;
    case Ground::matt:
      return GROUND_MATT;
    case Ground::glossy:
      return GROUND_GLOSSY;
  }
  return GROUND_NONE;
}

}  // namespace

device::FrameParameters frame_parameters(RenderRequest const& request, SceneShading const& scene, double lowest_point) {
  check_request(request);
  device::FrameParameters frame{};
  frame.camera = projective_camera(request.camera, request.resolution);
  frame.lens = thin_lens(request.camera);
  frame.ambient = device_float4(scene.ambient);
  Background const background = request.background.value_or(scene.background);
  frame.background = device_float4(background.mean());
  frame.background_top = device_float4(background.top);
  frame.background_step = device_float4((background.bottom - background.top) / double(request.resolution.height));
  frame.background_kind = background.kind == Background::Kind::environment ? BACKGROUND_ENVIRONMENT : BACKGROUND_COLORS;
  frame.region_x = device::uint(request.region.x);
  frame.region_y = device::uint(request.region.y);
  frame.region_width = device::uint(request.region.width);
  frame.region_height = device::uint(request.region.height);
  frame.sampling = sampling_of(request);
  frame.sample_count = device::uint(request.sampling.count);
  frame.seed_low = device::uint(request.seed);
  frame.seed_high = device::uint(request.seed >> 32);
  frame.max_indirect = float(request.max_indirect);
  bool const has_ground = request.ground != Ground::none && std::isfinite(lowest_point);
  bool const is_lit = request.planes.has(FilmPlane::radiance) || (has_ground && has_shadows_in_alpha(request));
  frame.max_depth = is_lit ? device::uint(request.max_depth) : 0;
  frame.ground = has_ground && is_lit ? ground_of(request.ground) : GROUND_NONE;
  frame.ground_plane = device_float4(unit_vector(scene.up));
  frame.ground_plane.w = has_ground ? float(lowest_point) : 0;
  return frame;
}

}  // namespace lichtraum
