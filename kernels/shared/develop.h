#ifndef LICHTRAUM_SHARED_DEVELOP_H
#define LICHTRAUM_SHARED_DEVELOP_H

/* From the sums of a film to what a picture stores, for programs of one lane. */

#include "shared/film.h"
#include "shared/math.h"

DEVICE_NAMESPACE_BEGIN

/* c / (c + 1) per channel: Reinhard, Stark, Shirley and Ferwerda, "Photographic Tone Reproduction for Digital Images"
 * (2002), equation 3. */
SHARED_FUNCTION float tone_map_channel(float c, uint tone_map) {
  if (tone_map != TONE_MAP_REINHARD) {
    return c;
  }
  return c < INFINITY ? c / (c + 1.f) : 1.f;
}

/* IEC 61966-2-1: a straight line near black, then a power. */
SHARED_FUNCTION float transfer_channel(float c, uint transfer) {
  if (transfer != TRANSFER_SRGB) {
    return c;
  }
  return c <= 0.0031308f ? 12.92f * c : fma(1.055f, pow_of(c, 1.f / 2.4f), -0.055f);
}

SHARED_FUNCTION float develop_channel(float radiance, DevelopParameters parameters) {
  return transfer_channel(tone_map_channel(parameters.exposure * radiance, parameters.tone_map), parameters.transfer);
}

/* A channel of a pixel's radiance, a sum; nothing is clamped. */
SHARED_FUNCTION float develop_mean(float sum, DevelopParameters parameters) {
  return develop_channel(sum / parameters.sample_count, parameters);
}

/* Where only some of the samples hit something, which `alpha` counts: the colour of what they hit. */
SHARED_FUNCTION float develop_straight(float sum, float alpha, DevelopParameters parameters) {
  return alpha > 0.f ? develop_channel(sum / alpha, parameters) : 0.f;
}

DEVICE_NAMESPACE_END

#endif
