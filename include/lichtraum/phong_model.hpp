#pragma once

#include "lichtraum/api.hpp"
#include "lichtraum/math.hpp"
#include "shared/phong_fields.h"

namespace LICHTRAUM_API lichtraum {

/// Phong's coefficients (Phong 1975) with Whitted's mirror and glass terms (Whitted 1980). A surface shows
///   emission + (1 - reflect - transmit) * (ambient + diffuse) + specular highlight
///   + reflect * (what its mirror ray sees) + transmit * (what its refracted ray sees).
/// Light grey and matt unless told otherwise. shared/phong_fields.h says what each field means.
struct PhongModel {
#define LICHTRAUM_COLOR(name, initial) Rgb name{initial};
#define LICHTRAUM_SHARE(name, initial) double name = initial;
#define LICHTRAUM_NUMBER(name, initial, least, most) double name = initial;
  PHONG_FIELDS(LICHTRAUM_COLOR, LICHTRAUM_SHARE, LICHTRAUM_NUMBER)
#undef LICHTRAUM_COLOR
#undef LICHTRAUM_SHARE
#undef LICHTRAUM_NUMBER
};

}  // namespace lichtraum
