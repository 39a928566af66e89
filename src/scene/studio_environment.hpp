#pragma once

#include <memory>

#include "lichtraum/environment.hpp"

namespace lichtraum {

/// A photographer's studio, neutral white, 1024 x 512, made by code: a large soft box to the upper left of who looks
/// along -z, a weaker one to the right, two behind for the outlines, a glow from the floor, a dim surround. A white
/// diffuse sphere is lit to 0.7 on the average, and to 0.8 where that viewer sees it. Always the same map.
std::shared_ptr<EnvironmentMap const> studio_environment();

}  // namespace lichtraum
