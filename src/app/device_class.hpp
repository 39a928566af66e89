#pragma once

#include <string>

#include "farm/plan.hpp"
#include "lichtraum/renderer.hpp"

namespace lichtraum::app {

/// What the renderer computes: a hash of lichtraum's version, of how rays find what they hit, and of small pictures by
/// every integrator, with all planes, and one of numbers that are denormal. The renderer has another scene
/// afterwards. `traversal`: as --traversal has it; empty: the device's default.
farm::DeviceClass device_class_of(Renderer& renderer, std::string const& traversal);

}  // namespace lichtraum::app
