#ifndef LICHTRAUM_SHARED_TONE_MAP_H
#define LICHTRAUM_SHARED_TONE_MAP_H

/* Tone maps: from linear light without a limit to linear light that can be displayed, 0..1. For programs of one lane.
 */

#include "shared/film.h"
#include "shared/math.h"

DEVICE_NAMESPACE_BEGIN

/* Linear light of Rec. 709's primaries. */
typedef struct {
  float r;
  float g;
  float b;
} LinearColor;

SHARED_FUNCTION LinearColor linear_color(float r, float g, float b) {
  LinearColor const color = {r, g, b};
  return color;
}

SHARED_FUNCTION float weighted_sum(LinearColor color, float r, float g, float b) {
  return r * color.r + g * color.g + b * color.b;
}

/* NaN becomes 0. */
SHARED_FUNCTION float limit_channel(float c, float most) { return c > 0.f ? (c < most ? c : most) : 0.f; }

SHARED_FUNCTION LinearColor limit_color(LinearColor color, float most) {
  return linear_color(limit_channel(color.r, most), limit_channel(color.g, most), limit_channel(color.b, most));
}

/* c / (c + 1) per channel: Reinhard, Stark, Shirley and Ferwerda, "Photographic Tone Reproduction for Digital Images"
 * (2002), equation 3. */
SHARED_FUNCTION float reinhard_channel(float c) { return c < INFINITY ? c / (c + 1.f) : 1.f; }

/* Khronos PBR Neutral (the Khronos Group's specification of 2024, "Khronos PBR Neutral Tone Mapper"): base colours in
 * white light are displayed as they are. What a dielectric reflects of it, 0.04, is taken off; only what is then above
 * 0.8 - 0.04 is compressed, and turns white the more it is. */
SHARED_FUNCTION LinearColor neutral_tone_map(LinearColor color) {
  float const reflected = 0.04f;
  float const compression_start = 0.8f - 0.04f;
  float const room = 1.f - compression_start;
  float const desaturation = 0.15f;
  float const less = color.g < color.b ? color.g : color.b;
  float const least = color.r < less ? color.r : less;
  /* A parabola from 0 that goes over into the constant at 2 * reflected. */
  float const offset = least < 2.f * reflected ? least - least * least / (4.f * reflected) : reflected;
  color = linear_color(color.r - offset, color.g - offset, color.b - offset);
  float const more = color.g > color.b ? color.g : color.b;
  float const peak = color.r > more ? color.r : more;
  if (peak < compression_start) {
    return color;
  }
  float const displayed_peak = 1.f - room * room / (peak + room - compression_start);
  float const scale = displayed_peak / peak;
  float const whiteness = 1.f - 1.f / (desaturation * (peak - displayed_peak) + 1.f);
  return linear_color(fma(whiteness, displayed_peak - scale * color.r, scale * color.r),
                      fma(whiteness, displayed_peak - scale * color.g, scale * color.g),
                      fma(whiteness, displayed_peak - scale * color.b, scale * color.b));
}

/* Stephen Hill's fit of ACES' reference rendering transform and its output transform for sRGB (in M. Pettineo's
 * BakingLab, 2016): the matrices lead to a space between the primaries of ACEScg and back. Brighter by 1 / 0.6, as
 * three.js has it, so that middle grey is as bright as with the other curves. */
SHARED_FUNCTION float aces_channel(float c) {
  return (c * (c + 0.0245786f) - 0.000090537f) / (c * (0.983729f * c + 0.432951f) + 0.238081f);
}

SHARED_FUNCTION LinearColor aces_tone_map(LinearColor color) {
  float const exposure = 1.f / 0.6f;
  LinearColor const scaled = linear_color(exposure * color.r, exposure * color.g, exposure * color.b);
  LinearColor const toned = linear_color(aces_channel(weighted_sum(scaled, 0.59719f, 0.35458f, 0.04823f)),
                                         aces_channel(weighted_sum(scaled, 0.076f, 0.90834f, 0.01566f)),
                                         aces_channel(weighted_sum(scaled, 0.0284f, 0.13383f, 0.83777f)));
  return linear_color(weighted_sum(toned, 1.60475f, -0.53108f, -0.07367f),
                      weighted_sum(toned, -0.10208f, 1.10813f, -0.00605f),
                      weighted_sum(toned, -0.00327f, -0.07276f, 1.07602f));
}

/* AgX (T. Sobotka), in the form of Blender's and three.js: a logarithm of 16.5 stops around middle grey, then B.
 * Wrensch's polynomial for the sigmoid ("Minimal AgX Implementation", 2023). Its value is a stored one, of gamma 2.2.
 */
SHARED_FUNCTION float agx_channel(float c) {
  float const darkest_ev = -12.47393f;
  float const brightest_ev = 4.026069f;
  float low;
  float const ev = log2_as_sum(c > 1e-10f ? c : 1e-10f, &low);
  float const x = limit_channel((ev - darkest_ev) / (brightest_ev - darkest_ev), 1.f);
  float y = 15.5f;
  y = fma(y, x, -40.14f);
  y = fma(y, x, 31.96f);
  y = fma(y, x, -6.868f);
  y = fma(y, x, 0.4298f);
  y = fma(y, x, 0.1191f);
  return fma(y, x, -0.00232f);
}

SHARED_FUNCTION float agx_linear(float stored) { return pow_of(stored > 0.f ? stored : 0.f, 2.2f); }

/* The first matrix leads from Rec. 709's to Rec. 2020's primaries (by their chromaticities) and those nearer to white,
 * where bright colours fade as on film; the second one away from white, the third back to Rec. 709's. Each row's sum is
 * 1: grey stays grey. */
SHARED_FUNCTION LinearColor agx_tone_map(LinearColor color) {
  LinearColor const toned = linear_color(agx_channel(weighted_sum(color, 0.544814746f, 0.373787398f, 0.081397855f)),
                                         agx_channel(weighted_sum(color, 0.140416948f, 0.754137555f, 0.105445497f)),
                                         agx_channel(weighted_sum(color, 0.08881042f, 0.178871756f, 0.732317824f)));
  LinearColor const wide = linear_color(agx_linear(weighted_sum(toned, 1.127100582f, -0.110606643f, -0.016493939f)),
                                        agx_linear(weighted_sum(toned, -0.141329763f, 1.157823702f, -0.016493939f)),
                                        agx_linear(weighted_sum(toned, -0.141329763f, -0.110606643f, 1.251936407f)));
  return linear_color(weighted_sum(wide, 1.660491002f, -0.587641139f, -0.072849863f),
                      weighted_sum(wide, -0.124550475f, 1.132899897f, -0.008349423f),
                      weighted_sum(wide, -0.018150763f, -0.100578898f, 1.118729661f));
}

/* `tone_map`: TONE_MAP_... */
SHARED_FUNCTION LinearColor map_tone(LinearColor color, uint tone_map) {
  if (tone_map == TONE_MAP_NONE) {
    return color;
  }
  if (tone_map == TONE_MAP_REINHARD) {
    return linear_color(reinhard_channel(color.r), reinhard_channel(color.g), reinhard_channel(color.b));
  }
  /* All is white long before squares of it are infinite. */
  LinearColor const light = limit_color(color, 1e15f);
  return limit_color(tone_map == TONE_MAP_NEUTRAL ? neutral_tone_map(light)
                     : tone_map == TONE_MAP_AGX   ? agx_tone_map(light)
                                                  : aces_tone_map(light),
                     1.f);
}

DEVICE_NAMESPACE_END

#endif
