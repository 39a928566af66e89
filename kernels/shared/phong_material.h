#ifndef LICHTRAUM_SHARED_PHONG_MATERIAL_H
#define LICHTRAUM_SHARED_PHONG_MATERIAL_H

#include "shared/phong_fields.h"
#include "shared/types.h"

DEVICE_NAMESPACE_BEGIN

typedef struct {
#define PHONG_COLOR(name, initial) float name[3];
#define PHONG_SHARE(name, initial) float name;
#define PHONG_NUMBER(name, initial, least, most) float name;
  PHONG_FIELDS(PHONG_COLOR, PHONG_SHARE, PHONG_NUMBER)
#undef PHONG_COLOR
#undef PHONG_SHARE
#undef PHONG_NUMBER
} PhongMaterial;
DEVICE_STRUCT_SIZE(PhongMaterial, 64);

DEVICE_NAMESPACE_END

#endif
