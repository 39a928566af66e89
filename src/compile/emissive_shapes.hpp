#pragma once

#include <span>
#include <vector>

#include "compile/scene_buffers.hpp"

namespace lichtraum {

/// Lists the shapes that shine, once for each instance: triangles, and what is sampled by its direction: spheres,
/// ellipsoids and boxes that nothing shows through. Light from other shapes is found by chance only, and so is all
/// where very many shine. Shapes must be in place; `objects` and `instances` are as FlatScene has them, `world` is what
/// objects[0] became.
void find_emissive_shapes(SceneBuffers& scene, std::vector<CompiledObject> const& objects, CompiledObject const& world,
                          std::span<FlatInstance const> instances);

}  // namespace lichtraum
