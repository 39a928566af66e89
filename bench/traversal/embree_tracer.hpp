#pragma once

#include <memory>

#include "bench_rays.hpp"

namespace lichtraum::bench {

/// Embree on as many threads as asked for, with one static scene of triangles.
class EmbreeTracer {
 public:
  enum class Quality { medium, high };
  /// Builds the scene; keeps the mesh in Embree's own buffers.
  EmbreeTracer(TriangleMesh const& mesh, Quality quality, int threads);
  ~EmbreeTracer();

  double build_ms() const;            ///< of rtcCommitScene
  double build_processor_ms() const;  ///< of all its threads
  std::size_t device_bytes() const;   ///< what Embree allocated for this scene

  void closest(PrimaryRays const& rays, std::vector<RayHit>& hits, bool packets) const;
  void any(ShadowRays const& rays, std::vector<std::uint8_t>& occluded, bool packets) const;
  void closest(FreeRays const& rays, std::vector<RayHit>& hits, bool packets) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace lichtraum::bench
