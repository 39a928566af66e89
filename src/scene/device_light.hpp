#pragma once

#include <optional>

#include "lichtraum/light.hpp"
#include "shared/light.h"

namespace lichtraum {

/// The light as kernels read it, all but `is_near`; nothing for one that casts no shadows.
std::optional<device::PunctualLight> device_light(Light const& light);

}  // namespace lichtraum
