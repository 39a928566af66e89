#pragma once

#include <memory>

#include "bench_rays.hpp"
#include "compile/scene_buffers.hpp"

namespace lichtraum::bench {

/// The project's kernels, one layout, on the first OpenCL CPU device.
class OpenClTracer {
 public:
  OpenClTracer(SceneBuffers& scene, Traversal layout);
  ~OpenClTracer();

  void closest(PrimaryRays const& rays, std::vector<RayHit>& hits) const;
  void any(ShadowRays const& rays, std::vector<std::uint8_t>& occluded) const;
  void closest(FreeRays const& rays, std::vector<RayHit>& hits) const;
  void any(FreeRays const& rays, std::vector<std::uint8_t>& occluded) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace lichtraum::bench
