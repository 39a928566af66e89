#pragma once

#include "app/console.hpp"
#include "app/picture_plan.hpp"
#include "app/render_statistics.hpp"

namespace lichtraum::app {

/// Loads one scene, draws its pictures and writes them. Throws Error; what was done until then is in `report`.
void draw_scene(SceneSource const& source, RenderOptions const& options, OutputNames& names, Renderer& renderer,
                Console const& console, SceneReport& report);

}  // namespace lichtraum::app
