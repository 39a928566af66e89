#pragma once

#include <memory>

#include "compile/scene_buffers.hpp"
#include "denoise/noise_planes.hpp"
#include "lichtraum/renderer.hpp"
#include "shared/film.h"
#include "shared/frame.h"

namespace lichtraum {

/// One OpenCL device with a scene on it, which traces tiles of pictures and
/// develops them. No OpenCL type shows.
class TileTracer {
 public:
  /// Throws DeviceError when the device described by `device` is gone or fails.
  TileTracer(DeviceInfo const& device, RayGrouping grouping);
  ~TileTracer();

  /// Makes the scene the device's own. CPU devices read it where it is, without a copy; nothing happens for the scene
  /// that is there already. Throws Error{no_device} with the numbers when it does not fit.
  /// `tables`: the scene's own, or others instead; where the scene is there already they are all that is made again.
  void upload(std::shared_ptr<SceneBuffers const> scene, std::shared_ptr<ShadingTables const> tables);
  std::uint64_t device_bytes() const;

  /// Whether begin_frame waits for the device's compiler.
  bool needs_compiler(device::FrameParameters const& frame, Integrator integrator, PlaneSet const& planes) const;
  /// Begins with a block of a film's samples, or goes on with it. `film` must stay until end_frame, which makes the
  /// device's work visible in it.
  void begin_frame(device::FrameParameters const& frame, Integrator integrator, Film& film);
  /// Traces a tile and waits for it. The tile's first_sample begins the block, or follows on what was traced before.
  RayCounts trace(device::Tile const& tile);
  void end_frame();

  /// See develop_sums (src/film/develop.hpp), with the same bytes.
  void develop(std::vector<float>& radiance, std::vector<float> const& alpha,
               device::DevelopParameters const& parameters);

  /// The passes of the built-in filter against noise.
  void filter_noise(NoisePlanes& planes);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace lichtraum
