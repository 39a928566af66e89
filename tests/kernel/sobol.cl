#include "math/real.clh"
#include "shared/sobol.h"

/* Keys are pixel_x, pixel_y, dimension, for LANES of them a work-item. */
__kernel void probe_sobol(__global uint4 const* keys, uint sample, uint seed_low, uint seed_high,
                          __global float2* points) {
  size_t const first = get_global_id(0) * LANES;
  Word pixel_x, pixel_y, dimension;
  for (uint lane = 0u; lane < LANES; ++lane) {
    LANE_WORD(pixel_x, lane) = keys[first + lane].x;
    LANE_WORD(pixel_y, lane) = keys[first + lane].y;
    LANE_WORD(dimension, lane) = keys[first + lane].z;
  }
  SobolPoint point = sobol_point(pixel_x, pixel_y, dimension, (Word)(sample), seed_low, seed_high);
  for (uint lane = 0u; lane < LANES; ++lane) {
    points[first + lane] = (float2)(LANE_FLOAT(point.x, lane), LANE_FLOAT(point.y, lane));
  }
}
