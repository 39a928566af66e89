#pragma once

#include <span>
#include <vector>

#include "compile/scene_buffers.hpp"

namespace lichtraum {

/// Which materials shine, by their numbers.
std::vector<bool> emissive_materials(device::ShadingArrays const& tables);

/// Which light a path looks for at a surface: tables to choose one by what it is likely to add, from `lights`, the
/// environment, the emissive triangles and solids, in this order. What may change are the tables' materials, lights and
/// environment; a material that did not shine when the scene was compiled is not among them.
void set_light_choices(ShadingTables& tables, SceneBuffers const& scene);

}  // namespace lichtraum
