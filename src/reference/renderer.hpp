#pragma once

#include <memory>

#include "lichtraum/renderer.hpp"

namespace lichtraum {

/// Traces the scene graph as it is, in double precision, on all cores: slow and obviously right. Scenes that draw more
/// than ten million primitives are refused, since every ray would be tested with each of them.
std::unique_ptr<Renderer> make_reference_renderer(DeviceInfo const& device = reference_device());

}  // namespace lichtraum
