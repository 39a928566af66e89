#ifndef LICHTRAUM_SHARED_DENOISE_H
#define LICHTRAUM_SHARED_DENOISE_H

/* The built-in filter against noise, for host and device: an edge-avoiding a-trous wavelet transform (Dammertz, Sewtz,
 * Hanika and Lensch, "Edge-Avoiding A-Trous Wavelet Transform for fast Global Illumination Filtering", 2010), guided by
 * the variance of the light as in SVGF (Schied et al., "Spatiotemporal Variance-Guided Filtering", 2017). Passes over
 * the picture, each of which has the one before as its input:
 *
 *   estimate_variance            the light's variance, from neighbours on the same surface
 *   for the steps 1, 2, 4, 8:    (NOISE_FILTER_LEVELS)
 *     smooth_luminance           what the light of two pixels is compared by
 *     filter_level               means of 5x5 pixels that are `step` apart
 *
 * Light is radiance divided by albedo, so that textures stay sharp whatever is mixed.
 *
 * A pixel's numbers lie in planes. In each, a row has `stride` numbers, of which the first `width` count; NOISE_FILTER_
 * MARGIN numbers come before the first row and after the last. Guides are NaN beside the picture, which no weight
 * survives: so columns need no border of their own. */

#include "shared/real.h"

#define NOISE_FILTER_LEVELS 4u
/* How far the last level reaches (two steps of eight), which is also how many pixels a group of lanes has. */
#define NOISE_FILTER_MARGIN 16u

/* The planes of the guides ... */
#define GUIDE_NORMAL 0u        /* three: x, y, z */
#define GUIDE_ALBEDO 3u        /* three: red, green, blue */
#define GUIDE_INVERSE_DEPTH 6u /* 0 where nothing is */
#define GUIDE_PLANES 7u
/* ... of the light ... */
#define LIGHT_COLOR 0u /* three: red, green, blue */
#define LIGHT_VARIANCE 3u
#define LIGHT_PLANES 4u
/* ... and of its luminance, smoothed. */
#define LUMINANCE_MEAN 0u
#define LUMINANCE_VARIANCE 1u
#define LUMINANCE_PLANES 2u

DEVICE_NAMESPACE_BEGIN

typedef struct {
  uint width;  /* of the picture, pixels */
  uint height; /* rows */
  uint stride; /* from row to row, numbers */
  uint plane;  /* from plane to plane, numbers */
} NoiseFilterLayout;
DEVICE_STRUCT_SIZE(NoiseFilterLayout, 16);

/* Differences at which weights have fallen to some 1/e: of normals, of albedos (lengths of vectors), of depth (its
 * share for each pixel of distance) and of light (standard deviations). Found by trial with path-traced pictures. */
#define NORMAL_TOLERANCE 0.2f
#define ALBEDO_TOLERANCE 0.4f
#define DEPTH_TOLERANCE 0.04f
#define LIGHT_TOLERANCE 3.0f
/* Light that differs by so much of itself is the same, whatever the variance. */
#define SAME_LIGHT 1e-3f
#define LEAST_NUMBER 1e-30f

/* Of the column x and the row y, in a plane. */
SHARED_FUNCTION size_t filter_place(NoiseFilterLayout layout, int x, int y) {
  return (size_t)((int)NOISE_FILTER_MARGIN + x) + (size_t)layout.stride * (size_t)y;
}

SHARED_FUNCTION int has_row(NoiseFilterLayout layout, int y) { return y >= 0 && y < (int)layout.height; }

/* Close to e^-x, and exactly 1 for 0; 0 for x >= 4 and for what is not a number. */
SHARED_FUNCTION Real fall_off(Real x) {
  Real const rest = 1.0f - 0.25f * x;
  Real const squared = rest > 0.0f ? rest * rest : (Real)(0.0f);
  return squared * squared;
}

/* What the guides say about a pixel. */
typedef struct {
  Real normal_x, normal_y, normal_z;
  Real red, green, blue; /* albedo */
  Real inverse_depth;
} FilteredSurface;

SHARED_FUNCTION FilteredSurface surface_at(NoiseFilterLayout layout, DEVICE_MEMORY float const* guides, size_t place) {
  size_t const plane = layout.plane;
  DEVICE_MEMORY float const* const normal = guides + GUIDE_NORMAL * plane + place;
  DEVICE_MEMORY float const* const albedo = guides + GUIDE_ALBEDO * plane + place;
  FilteredSurface surface;
  surface.normal_x = real_at(normal);
  surface.normal_y = real_at(normal + plane);
  surface.normal_z = real_at(normal + 2 * plane);
  surface.red = real_at(albedo);
  surface.green = real_at(albedo + plane);
  surface.blue = real_at(albedo + 2 * plane);
  surface.inverse_depth = real_at(guides + GUIDE_INVERSE_DEPTH * plane + place);
  return surface;
}

/* For surface_difference: by what differences of inverse depth count. */
SHARED_FUNCTION Real depth_scale(FilteredSurface const* surface) {
  return 1.0f / (DEPTH_TOLERANCE * surface->inverse_depth + LEAST_NUMBER);
}

/* How different a surface is from that of another place, `distance` pixels apart: for fall_off. */
SHARED_FUNCTION Real surface_difference(NoiseFilterLayout layout, DEVICE_MEMORY float const* guides,
                                        FilteredSurface const* surface, Real scale, size_t place, float distance) {
  FilteredSurface const other = surface_at(layout, guides, place);
  Real const x = other.normal_x - surface->normal_x;
  Real const y = other.normal_y - surface->normal_y;
  Real const z = other.normal_z - surface->normal_z;
  Real const red = other.red - surface->red;
  Real const green = other.green - surface->green;
  Real const blue = other.blue - surface->blue;
  Real const depth = fabs(other.inverse_depth - surface->inverse_depth);
  return (x * x + y * y + z * z) * (1.0f / (NORMAL_TOLERANCE * NORMAL_TOLERANCE)) +
         (red * red + green * green + blue * blue) * (1.0f / (ALBEDO_TOLERANCE * ALBEDO_TOLERANCE)) +
         depth * scale * (1.0f / distance);
}

SHARED_FUNCTION Real luminance_at(NoiseFilterLayout layout, DEVICE_MEMORY float const* light, size_t place) {
  DEVICE_MEMORY float const* const color = light + LIGHT_COLOR * (size_t)layout.plane + place;
  return 0.25f * real_at(color) + 0.5f * real_at(color + layout.plane) + 0.25f * real_at(color + 2 * layout.plane);
}

/* Of taps that are `step` apart; not 0 for a pixel itself, which divides by it. */
SHARED_FUNCTION float pixel_distance(int dx, int dy, int step) {
  return (float)step * sqrt((float)(dx * dx + dy * dy + (dx == 0 && dy == 0 ? 1 : 0)));
}

/* The passes, each for the pixels that begin at column x of row y: a pixel, or a group of LANES. */

/* Half the mean square of what neighbours on the same surface differ by. Light's own edges add to it: there is no
 * telling them from noise in a picture alone. */
SHARED_FUNCTION void estimate_variance(NoiseFilterLayout layout, int x, int y, DEVICE_MEMORY float const* guides,
                                       DEVICE_MEMORY float* light) {
  size_t const place = filter_place(layout, x, y);
  FilteredSurface const surface = surface_at(layout, guides, place);
  Real const scale = depth_scale(&surface);
  Real const luminance = luminance_at(layout, light, place);
  Real sum = (Real)(0.0f);
  Real weights = (Real)(0.0f);
  for (int dy = -1; dy <= 1; ++dy) {
    if (!has_row(layout, y + dy)) {
      continue;
    }
    for (int dx = -1; dx <= 1; ++dx) {
      if (dx == 0 && dy == 0) {
        continue;
      }
      size_t const other = filter_place(layout, x + dx, y + dy);
      Real const weight =
          fall_off(surface_difference(layout, guides, &surface, scale, other, pixel_distance(dx, dy, 1)));
      Real const difference = luminance_at(layout, light, other) - luminance;
      sum = sum + weight * (0.5f * (difference * difference));
      weights = weights + weight;
    }
  }
  put_real(weights > 0.0f ? sum / weights : (Real)(0.0f), light + LIGHT_VARIANCE * (size_t)layout.plane + place);
}

/* The mean of 3x3 pixels of the same surface, and the variance of that mean. Two pixels' light is compared by it: their
 * own differ by noise alone. */
SHARED_FUNCTION void smooth_luminance(NoiseFilterLayout layout, int step, int x, int y,
                                      DEVICE_MEMORY float const* guides, DEVICE_MEMORY float const* light,
                                      DEVICE_MEMORY float* luminance) {
  size_t const plane = layout.plane;
  size_t const place = filter_place(layout, x, y);
  FilteredSurface const surface = surface_at(layout, guides, place);
  Real const scale = depth_scale(&surface);
  Real mean = (Real)(0.0f);
  Real variance = (Real)(0.0f);
  Real weights = (Real)(0.0f);
  for (int dy = -1; dy <= 1; ++dy) {
    if (!has_row(layout, y + dy * step)) {
      continue;
    }
    for (int dx = -1; dx <= 1; ++dx) {
      size_t const other = filter_place(layout, x + dx * step, y + dy * step);
      float const share = (dx == 0 ? 1.0f : 0.5f) * (dy == 0 ? 1.0f : 0.5f);
      Real const weight =
          share * fall_off(surface_difference(layout, guides, &surface, scale, other, pixel_distance(dx, dy, step)));
      mean = mean + weight * luminance_at(layout, light, other);
      variance = variance + weight * weight * real_at(light + LIGHT_VARIANCE * plane + other);
      weights = weights + weight;
    }
  }
  /* Beside the picture nothing has a weight. */
  Real const per_weight = weights > 0.0f ? 1.0f / weights : (Real)(0.0f);
  put_real(mean * per_weight, luminance + LUMINANCE_MEAN * plane + place);
  put_real(variance * per_weight * per_weight, luminance + LUMINANCE_VARIANCE * plane + place);
}

/* The variance of the smoothed luminance around a place, by a triangle of 3x3: that of one pixel is itself noisy.
 * Beside the picture it is 0. */
SHARED_FUNCTION Real variance_around(NoiseFilterLayout layout, int x, int y, DEVICE_MEMORY float const* luminance) {
  DEVICE_MEMORY float const* const variance = luminance + LUMINANCE_VARIANCE * (size_t)layout.plane;
  Real sum = (Real)(0.0f);
  float shares = 0.0f;
  for (int dy = -1; dy <= 1; ++dy) {
    if (!has_row(layout, y + dy)) {
      continue;
    }
    for (int dx = -1; dx <= 1; ++dx) {
      float const share = (dx == 0 ? 1.0f : 0.5f) * (dy == 0 ? 1.0f : 0.5f);
      sum = sum + share * real_at(variance + filter_place(layout, x + dx, y + dy));
      shares = shares + share;
    }
  }
  return sum / shares;
}

SHARED_FUNCTION void filter_level(NoiseFilterLayout layout, int step, int x, int y, DEVICE_MEMORY float const* guides,
                                  DEVICE_MEMORY float const* light, DEVICE_MEMORY float const* luminance,
                                  DEVICE_MEMORY float* filtered) {
  size_t const plane = layout.plane;
  size_t const place = filter_place(layout, x, y);
  FilteredSurface const surface = surface_at(layout, guides, place);
  Real const scale = depth_scale(&surface);
  Real const mean = real_at(luminance + LUMINANCE_MEAN * plane + place);
  Real const tolerated = variance_around(layout, x, y, luminance) + (SAME_LIGHT * SAME_LIGHT) * (mean * mean);
  Real const light_scale = 1.0f / ((LIGHT_TOLERANCE * LIGHT_TOLERANCE) * tolerated + LEAST_NUMBER);
  Real red = (Real)(0.0f);
  Real green = (Real)(0.0f);
  Real blue = (Real)(0.0f);
  Real variance = (Real)(0.0f);
  Real weights = (Real)(0.0f);
  for (int dy = -2; dy <= 2; ++dy) {
    if (!has_row(layout, y + dy * step)) {
      continue;
    }
    /* The B3 spline's 1/16, 1/4, 3/8, 1/4, 1/16 in both directions. */
    float const row_share = dy == 0 ? 0.375f : (dy * dy == 1 ? 0.25f : 0.0625f);
    for (int dx = -2; dx <= 2; ++dx) {
      float const share = row_share * (dx == 0 ? 0.375f : (dx * dx == 1 ? 0.25f : 0.0625f));
      size_t const other = filter_place(layout, x + dx * step, y + dy * step);
      Real const difference = real_at(luminance + LUMINANCE_MEAN * plane + other) - mean;
      Real const weight =
          share * fall_off(surface_difference(layout, guides, &surface, scale, other, pixel_distance(dx, dy, step)) +
                           difference * difference * light_scale);
      DEVICE_MEMORY float const* const color = light + LIGHT_COLOR * plane + other;
      red = red + weight * real_at(color);
      green = green + weight * real_at(color + plane);
      blue = blue + weight * real_at(color + 2 * plane);
      variance = variance + weight * weight * real_at(light + LIGHT_VARIANCE * plane + other);
      weights = weights + weight;
    }
  }
  Real const per_weight = weights > 0.0f ? 1.0f / weights : (Real)(0.0f);
  put_real(red * per_weight, filtered + LIGHT_COLOR * plane + place);
  put_real(green * per_weight, filtered + (LIGHT_COLOR + 1u) * plane + place);
  put_real(blue * per_weight, filtered + (LIGHT_COLOR + 2u) * plane + place);
  put_real(variance * per_weight * per_weight, filtered + LIGHT_VARIANCE * plane + place);
}

DEVICE_NAMESPACE_END

#endif
