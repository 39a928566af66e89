/* Develops the sums of a film, where they are: a work-item a pixel, whose radiance is three values. The host's
 * lichtraum::develop gives the same bytes. */
#define LANES 1
#include "shared/develop.h"

static inline void develop_pixel(DevelopParameters parameters, float sample_count, __global float* radiance) {
  LinearColor const sum = {radiance[0], radiance[1], radiance[2]};
  LinearColor const developed = develop_sum(sum, sample_count, parameters);
  radiance[0] = developed.r;
  radiance[1] = developed.g;
  radiance[2] = developed.b;
}

__kernel void develop(DevelopParameters const parameters, ulong const pixel_count, __global float* radiance) {
  size_t const i = get_global_id(0);
  if (i < pixel_count) {
    develop_pixel(parameters, parameters.sample_count, radiance + 3 * i);
  }
}

/* Where only some of the samples hit something, which `alpha` counts: the colour of what they hit. It stays a sum. */
__kernel void develop_straight_colors(DevelopParameters const parameters, ulong const pixel_count,
                                      __global float* radiance, __global float const* alpha) {
  size_t const i = get_global_id(0);
  if (i < pixel_count) {
    develop_pixel(parameters, alpha[i], radiance + 3 * i);
  }
}
