#ifndef LICHTRAUM_SHARED_DEVELOP_H
#define LICHTRAUM_SHARED_DEVELOP_H

/* From the sums of a film to what a picture stores, for programs of one lane. */

#include "shared/tone_map.h"

DEVICE_NAMESPACE_BEGIN

/* IEC 61966-2-1: a straight line near black, then a power. */
SHARED_FUNCTION float transfer_channel(float c, uint transfer) {
  if (transfer != TRANSFER_SRGB) {
    return c;
  }
  return c <= 0.0031308f ? 12.92f * c : fma(1.055f, pow_of(c, 1.f / 2.4f), -0.055f);
}

SHARED_FUNCTION LinearColor develop_color(LinearColor radiance, DevelopParameters parameters) {
  float const exposure = parameters.exposure;
  LinearColor const exposed = linear_color(exposure * radiance.r, exposure * radiance.g, exposure * radiance.b);
  LinearColor const toned = map_tone(exposed, parameters.tone_map);
  uint const transfer = parameters.transfer;
  return linear_color(transfer_channel(toned.r, transfer), transfer_channel(toned.g, transfer),
                      transfer_channel(toned.b, transfer));
}

/* A pixel's radiance, a sum of so many samples; without a tone map nothing is clamped. With `count` 0, black. */
SHARED_FUNCTION LinearColor develop_sum(LinearColor sum, float count, DevelopParameters parameters) {
  LinearColor const black = {0.f, 0.f, 0.f};
  return count > 0.f ? develop_color(linear_color(sum.r / count, sum.g / count, sum.b / count), parameters) : black;
}

DEVICE_NAMESPACE_END

#endif
