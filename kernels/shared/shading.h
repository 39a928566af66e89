#ifndef LICHTRAUM_SHARED_SHADING_H
#define LICHTRAUM_SHARED_SHADING_H

#include "shared/types.h"

DEVICE_NAMESPACE_BEGIN

typedef struct {
  float4 ka;         /* w: specular exponent m */
  float4 kd;         /* w: reflect, 0..1 */
  float4 ks;         /* w: transmit, 0..1 */
  float ior;         /* > 0 */
  float emission[3]; /* what the surface shows without any light */
} PhongMaterial;
DEVICE_STRUCT_SIZE(PhongMaterial, 64);

typedef struct {
  float4 position; /* world; w: 1 when shadow rays may start here, as the scene is near enough for that; else 0 */
  float4 ld;       /* rgb; w unused */
} PointLight;
DEVICE_STRUCT_SIZE(PointLight, 32);

DEVICE_NAMESPACE_END

#endif
