/* Develops the sums of a film, where they are: a work-item a value of radiance. The host's lichtraum::develop gives the
 * same bytes. */
#define LANES 1
#include "shared/develop.h"

__kernel void develop(DevelopParameters const parameters, ulong const count, __global float* radiance) {
  size_t const i = get_global_id(0);
  if (i < count) {
    radiance[i] = develop_mean(radiance[i], parameters);
  }
}

/* With alpha, one for three values of radiance; it stays a sum. */
__kernel void develop_straight_colors(DevelopParameters const parameters, ulong const count, __global float* radiance,
                                      __global float const* alpha) {
  size_t const i = get_global_id(0);
  if (i < count) {
    radiance[i] = develop_straight(radiance[i], alpha[i / 3], parameters);
  }
}
