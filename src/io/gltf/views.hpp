#pragma once

#include "io/framing.hpp"
#include "io/gltf/node_tree.hpp"
#include "io/names.hpp"

namespace lichtraum::gltf {

/// The cameras that the scene's nodes hold, each named after its node.
std::vector<Camera> read_cameras(tinygltf::Model const& model, NodeTree const& tree, Findings& findings);

/// The lights of KHR_lights_punctual that the scene's nodes hold. Whitted's lights know neither units nor fall-off:
/// each gets the share of the light that it throws on the middle of `box`, and all together 1 there.
std::vector<Light> read_lights(tinygltf::Model const& model, NodeTree const& tree, Bounds const& box,
                               Findings& findings);

}  // namespace lichtraum::gltf
