#ifndef LICHTRAUM_SHARED_FILM_H
#define LICHTRAUM_SHARED_FILM_H

#include "shared/types.h"

/* What a film can hold, a bit each. */
#define PLANE_RADIANCE 1u
#define PLANE_ALPHA 2u
#define PLANE_ALBEDO 4u
#define PLANE_NORMAL 8u
#define PLANE_DEPTH 16u
#define PLANE_POSITION 32u
#define PLANE_OBJECT 64u
#define PLANE_INSTANCE 128u
#define PLANE_MATERIAL 256u

/* The planes of a film, in the order of include/lichtraum/film.hpp, which says what each holds: PLANE(type of an
 * element, name, bit, elements a pixel). Means of all samples ... */
#define FILM_MEAN_PLANES(PLANE)              \
  PLANE(float, radiance, PLANE_RADIANCE, 3u) \
  PLANE(float, alpha, PLANE_ALPHA, 1u)       \
  PLANE(float, albedo, PLANE_ALBEDO, 3u)     \
  PLANE(float, normal, PLANE_NORMAL, 3u)

/* ... and what the ray through a pixel's middle finds. */
#define FILM_CENTER_PLANES(PLANE)            \
  PLANE(float, depth, PLANE_DEPTH, 1u)       \
  PLANE(float, position, PLANE_POSITION, 3u) \
  PLANE(uint, object, PLANE_OBJECT, 1u)      \
  PLANE(uint, instance, PLANE_INSTANCE, 1u)  \
  PLANE(uint, material, PLANE_MATERIAL, 1u)
#define MEAN_PLANES (PLANE_RADIANCE | PLANE_ALPHA | PLANE_ALBEDO | PLANE_NORMAL)
#define CENTER_PLANES (PLANE_DEPTH | PLANE_POSITION | PLANE_OBJECT | PLANE_INSTANCE | PLANE_MATERIAL)

#define FILM_PLANES(PLANE) FILM_MEAN_PLANES(PLANE) FILM_CENTER_PLANES(PLANE)

/* Samples are added in blocks of so many, then the blocks; see include/lichtraum/film.hpp. */
#define FILM_BLOCK_SIZE 16u

DEVICE_NAMESPACE_BEGIN

#define TONE_MAP_NONE 0u
#define TONE_MAP_REINHARD 1u
#define TONE_MAP_NEUTRAL 2u
#define TONE_MAP_AGX 3u
#define TONE_MAP_ACES 4u
#define TRANSFER_LINEAR 0u
#define TRANSFER_SRGB 1u

/* From the sums of a film to what a picture stores. */
typedef struct {
  float sample_count; /* of which they are the sums */
  float exposure;     /* factor */
  uint tone_map;      /* TONE_MAP_... (shared/tone_map.h) */
  uint transfer;      /* TRANSFER_... */
} DevelopParameters;
DEVICE_STRUCT_SIZE(DevelopParameters, 16);

DEVICE_NAMESPACE_END

#endif
