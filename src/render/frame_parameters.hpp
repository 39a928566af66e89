#pragma once

#include "lichtraum/renderer.hpp"
#include "render/scene_shading.hpp"
#include "shared/frame.h"

namespace lichtraum {

/// The request as the kernel reads it. `root_node`: of the world's hierarchy. `light_count`: point lights.
/// Throws Error{usage} for a request that makes no sense: an empty or outside region, a grid that is no square, ...
device::FrameParameters frame_parameters(RenderRequest const& request, SceneShading const& scene,
                                         device::uint root_node, device::uint light_count);

}  // namespace lichtraum
