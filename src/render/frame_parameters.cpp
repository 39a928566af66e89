#include "render/frame_parameters.hpp"

#include <glm/trigonometric.hpp>

#include "core/elementary.hpp"
#include "render/check_request.hpp"
#include "scene/device_conversion.hpp"

namespace lichtraum {
namespace {

device::PinholeCamera pinhole_camera(Camera const& camera, Resolution const& size) {
  Transform const& world_from_camera = camera.world_from_camera();
  double const half_width = tan_of(glm::radians(0.5 * camera.fov_x_degrees()));
  double const half_height = half_width * size.height / size.width;
  return {device_float4(world_from_camera.point(Vec3(0))),
          device_float4(world_from_camera.vector({-half_width, half_height, -1})),
          device_float4(world_from_camera.vector({2 * half_width / size.width, 0, 0})),
          device_float4(world_from_camera.vector({0, -2 * half_height / size.height, 0}))};
}

device::uint device_tone_map(ToneMap tone_map) {
  return tone_map == ToneMap::reinhard ? TONE_MAP_REINHARD : TONE_MAP_NONE;
}

static_assert(int(Aov::depth) == AOV_DEPTH && int(Aov::normal) == AOV_NORMAL && int(Aov::object_id) == AOV_OBJECT_ID);

}  // namespace

device::FrameParameters frame_parameters(RenderRequest const& request, SceneShading const& scene) {
  check_request(request);
  device::FrameParameters frame{};
  frame.camera = pinhole_camera(request.camera, request.resolution);
  frame.ambient = device_float4(scene.ambient);
  frame.background = device_float4(scene.background);
  frame.width = device::uint(request.resolution.width);
  frame.height = device::uint(request.resolution.height);
  frame.sampling = request.sampling.pattern == Sampling::Pattern::grid ? SAMPLING_GRID : SAMPLING_SEEDED;
  frame.sample_count = device::uint(request.sampling.count);
  frame.seed_low = device::uint(request.seed);
  frame.seed_high = device::uint(request.seed >> 32);
  frame.max_depth = device::uint(request.max_depth);
  frame.tone_map = device_tone_map(request.tone_map == ToneMap::automatic ? scene.tone_map : request.tone_map);
  frame.transfer = request.transfer == Transfer::srgb ? TRANSFER_SRGB : TRANSFER_LINEAR;
  frame.aov = device::uint(request.aov);
  if (request.aov != Aov::picture) {
    frame.sampling = SAMPLING_GRID;
    frame.sample_count = 1;
    frame.max_depth = 0;
    frame.tone_map = TONE_MAP_NONE;
    frame.transfer = TRANSFER_LINEAR;
  }
  return frame;
}

}  // namespace lichtraum
