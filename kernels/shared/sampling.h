#ifndef LICHTRAUM_SHARED_SAMPLING_H
#define LICHTRAUM_SHARED_SAMPLING_H

#include "shared/types.h"

/* Where the seeded samples of a pixel lie. Integers and exact conversions only, so that host and device agree to the
 * last bit whatever their floating point does. */

DEVICE_NAMESPACE_BEGIN

/* A point of the unit square, from a pixel's top left corner: 0 <= x, y < 1, multiples of 2^-24. */
typedef struct {
  float x;
  float y;
} PixelOffset;
DEVICE_STRUCT_SIZE(PixelOffset, 8);

/* Two uniform numbers drawn from (pixel, sample, seed) and nothing else: the hash pcg4d of Jarzynski and Olano, "Hash
 * Functions for GPU Rendering", Journal of Computer Graphics Techniques 9(3), 2020, section 3. */
SHARED_FUNCTION PixelOffset seeded_pixel_offset(uint pixel_x, uint pixel_y, uint sample, uint seed_low,
                                                uint seed_high) {
  uint x = pixel_x * 1664525u + 1013904223u;
  uint y = pixel_y * 1664525u + 1013904223u + seed_high * 2654435769u;
  uint z = sample * 1664525u + 1013904223u;
  uint w = seed_low * 1664525u + 1013904223u;
  PixelOffset offset;
  x += y * w;
  y += z * x;
  z += x * y;
  w += y * z;
  x ^= x >> 16;
  y ^= y >> 16;
  z ^= z >> 16;
  w ^= w >> 16;
  x += y * w;
  y += z * x;
  offset.x = (float)(x >> 8) * (1.0f / 16777216.0f);
  offset.y = (float)(y >> 8) * (1.0f / 16777216.0f);
  return offset;
}

DEVICE_NAMESPACE_END

#endif
