#pragma once

#include <vector>

#include "core/big_vector.hpp"
#include "lichtraum/light.hpp"
#include "scene/device_bounds.hpp"
#include "shared/light.h"

namespace lichtraum {

/// The lights that cast shadows, as the kernels read them. `world_bounds`: of what is drawn.
BigVector<device::PunctualLight> make_light_table(std::vector<Light> const& lights, DeviceBounds const& world_bounds);

}  // namespace lichtraum
