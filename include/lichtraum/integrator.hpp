#pragma once

#include "shared/integrators.h"

#include "lichtraum/api.hpp"

namespace LICHTRAUM_API lichtraum {

/// How the radiance along the camera's rays is found: kernels/shared/integrators.h says what each is.
enum class Integrator {
#define LICHTRAUM_ENUMERATOR(name) name,
  INTEGRATORS(LICHTRAUM_ENUMERATOR)
#undef LICHTRAUM_ENUMERATOR
};

}  // namespace lichtraum
