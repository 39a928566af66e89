#pragma once

#include "cl/opencl.hpp"
#include "denoise/noise_planes.hpp"

namespace lichtraum {

/// kernels/denoise.cl on a device: lichtraum::filter_noise, with the same bytes.
class NoiseFilter {
 public:
  /// `program`: the DenoiseProgram of these lanes, 1 or 16 pixels a work-item.
  NoiseFilter(cl::Context const& context, cl::Program const& program, int lanes);

  /// Every pass over the planes, and waits. Throws DeviceError.
  void run(cl::CommandQueue const& queue, NoisePlanes& planes);
  /// Launches every kernel for no pixels, in small and in large grids, for which PoCL makes code of their own.
  void warm_up(cl::CommandQueue const& queue);

 private:
  cl::Context context_;
  int lanes_;
  cl::Kernel variance_, luminance_, level_;
};

}  // namespace lichtraum
