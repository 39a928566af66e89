/* The built-in filter against noise, a launch a pass: a work-item has a pixel, or sixteen of a row with LANES 16. The
 * host's lichtraum::filter_noise gives the same bytes. */
#ifndef LANES
#define LANES 1
#endif
#include "shared/denoise.h"

static inline int first_column(void) { return (int)get_global_id(0) * LANES; }

static inline bool is_inside(NoiseFilterLayout const layout) {
  return (uint)first_column() < layout.width && get_global_id(1) < layout.height;
}

__kernel void denoise_variance(NoiseFilterLayout const layout, __global float const* guides, __global float* light) {
  if (is_inside(layout)) {
    estimate_variance(layout, first_column(), (int)get_global_id(1), guides, light);
  }
}

__kernel void denoise_luminance(NoiseFilterLayout const layout, int const step, __global float const* guides,
                                __global float const* light, __global float* luminance) {
  if (is_inside(layout)) {
    smooth_luminance(layout, step, first_column(), (int)get_global_id(1), guides, light, luminance);
  }
}

__kernel void denoise_level(NoiseFilterLayout const layout, int const step, __global float const* guides,
                            __global float const* light, __global float const* luminance, __global float* filtered) {
  if (is_inside(layout)) {
    filter_level(layout, step, first_column(), (int)get_global_id(1), guides, light, luminance, filtered);
  }
}
