#pragma once

#include "lichtraum/scene.hpp"

namespace lichtraum::test {

/// Meshes that use all that vertices and textures can do: smooth and mapped normals with and without tangents, vertex
/// colours, two sets of texture coordinates, masks, blends, transmission; once and as instances under mirrored and
/// stretched transforms. Before a floor, with a camera called "eye" and one light of each kind.
Scene make_textured_scene();

}  // namespace lichtraum::test
