#pragma once

#include <memory>

#include "lichtraum/renderer.hpp"

namespace lichtraum {

/// Throws DeviceError when the device fails.
std::unique_ptr<Renderer> make_opencl_renderer(DeviceInfo const& device, Traversal traversal);

}  // namespace lichtraum
