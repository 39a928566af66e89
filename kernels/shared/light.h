#ifndef LICHTRAUM_SHARED_LIGHT_H
#define LICHTRAUM_SHARED_LIGHT_H

#include "shared/types.h"

DEVICE_NAMESPACE_BEGIN

#define LIGHT_CONSTANT 0u    /* a point; as bright at any distance */
#define LIGHT_FALLS_OFF 1u   /* a point or spot */
#define LIGHT_DIRECTIONAL 2u /* from infinitely far away */

/* KHR_lights_punctual has the formulae. */
typedef struct {
  float4 position;  /* world; directional: unit vector towards the light. w: 1 when shadow rays may start here, as the
                       scene is near enough for that; else 0 */
  float4 ld;        /* rgb: what arrives, of one that falls off at distance 1; w unused */
  float4 direction; /* unit, where a spot shines; w unused */
  float inverse_range; /* falls off to nothing at 1 / this */
  float cone_scale;    /* brightness in a cone: (cosine * scale + offset)^2, clamped to 0..1; 0 and 1 without cone */
  float cone_offset;
  uint kind; /* LIGHT_... */
} PunctualLight;
DEVICE_STRUCT_SIZE(PunctualLight, 64);

DEVICE_NAMESPACE_END

#endif
