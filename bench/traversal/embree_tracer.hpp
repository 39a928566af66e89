#pragma once

#include <memory>

#include "bench_rays.hpp"
#include "bench_scene.hpp"
#include "embree_api.hpp"

namespace lichtraum::bench {

/// One version of Embree on as many threads as asked for, with one static scene of triangles and instances.
class EmbreeTracer {
 public:
  enum class Quality { medium = 1, high = 2 };
  /// Copies the scene into Embree's own buffers. The library must outlive it.
  EmbreeTracer(embree::Library const& library, BenchScene const& scene, Quality quality, int threads);
  ~EmbreeTracer();

  void build();                      ///< rtcCommitScene, before anything is traced
  std::size_t device_bytes() const;  ///< what Embree allocated for this scene

  void closest(PrimaryRays const& rays, std::vector<RayHit>& hits, bool packets) const;
  void any(ShadowRays const& rays, std::vector<std::uint8_t>& occluded, bool packets) const;
  void closest(FreeRays const& rays, std::vector<RayHit>& hits, bool packets) const;
  void any(FreeRays const& rays, std::vector<std::uint8_t>& occluded, bool packets) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace lichtraum::bench
