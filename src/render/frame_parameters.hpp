#pragma once

#include "lichtraum/renderer.hpp"
#include "scene/scene_shading.hpp"
#include "shared/frame.h"

namespace lichtraum {

/// The request as the kernel reads it.
/// Throws Error{usage} for a request that makes no sense: an empty or outside region, a grid that is not square, ...
device::FrameParameters frame_parameters(RenderRequest const& request, SceneShading const& scene, double lowest_point);

}  // namespace lichtraum
