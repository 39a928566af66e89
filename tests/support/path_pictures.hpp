#pragma once

#include "lichtraum/image.hpp"
#include "lichtraum/renderer.hpp"

/// Pictures by paths on the first OpenCL device, and what is measured of them.

namespace lichtraum::test {

/// The whole picture of the scene's first camera, by always the same random numbers.
RenderRequest path_request(Scene const& scene, Resolution const& size, int samples, int max_depth);

/// Checks that no sample is infinite or no number.
Image trace(Scene const& scene, RenderRequest const& request);

/// Of the pixels' first channel; the error is how far the mean's is likely to be, pixels being independent.
struct Mean {
  double value = 0, error = 0, least = 1e30, most = -1e30;
};
Mean mean_of(Image const& image);

}  // namespace lichtraum::test
