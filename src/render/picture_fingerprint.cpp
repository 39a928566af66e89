#include "core/content_hash.hpp"
#include "film/trace_blocks.hpp"
#include "lichtraum/renderer.hpp"

namespace lichtraum {

std::string picture_fingerprint(PreparedScene const& scene, RenderRequest const& request,
                                Development const& development) {
  ContentHasher hasher;
  hasher.add(std::string_view(LICHTRAUM_VERSION));
  hasher.add(std::string_view(scene.fingerprint));
  hasher.add(request.camera.fov_x_degrees());
  if (request.camera.is_orthographic()) hasher.add(request.camera.width());
  hasher.add(request.camera.world_from_camera().matrix());
  hasher.add(request.camera.lens().aperture);
  hasher.add(request.camera.lens().focus_distance);
  hasher.add(request.resolution);
  hasher.add(request.region);
  hasher.add(int(request.sampling.pattern));
  hasher.add(request.sampling.count);
  hasher.add(int(request.integrator));
  hasher.add(request.max_depth);
  if (request.integrator == Integrator::path) {
    hasher.add(request.max_indirect);
    hasher.add(int(request.ground));
  }
  bool const is_random =
      request.integrator == Integrator::path || request.sampling.pattern == Sampling::Pattern::seeded;
  hasher.add(is_random ? request.seed : std::uint64_t(0));
  SampleRange const samples = wanted_samples(request);
  hasher.add(samples.first);
  hasher.add(samples.end);
  hasher.add(request.planes.bits());
  hasher.add(request.background.has_value());
  Background const background = request.background.value_or(Background());
  hasher.add(int(background.kind));
  hasher.add(background.top);
  hasher.add(background.bottom);
  hasher.add(development.exposure_ev);
  hasher.add(int(development.tone_map));
  hasher.add(int(development.transfer));
  return hasher.finish().text();
}

}  // namespace lichtraum
