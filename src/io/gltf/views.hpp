#pragma once

#include "io/framing.hpp"
#include "io/gltf/node_tree.hpp"
#include "io/names.hpp"

namespace lichtraum::gltf {

/// The cameras that the scene's nodes hold, each named after its node.
std::vector<Camera> read_cameras(tinygltf::Model const& model, NodeTree const& tree, Findings& findings);

/// The lights of KHR_lights_punctual that the scene's nodes hold, as the file has them: in candela, directional ones in
/// lux. Each is named after its node.
std::vector<Light> read_lights(tinygltf::Model const& model, NodeTree const& tree, Findings& findings);

/// One factor for all of `lights`: with it they throw as much light on the middle of `box` as one of eSDF's of Ld = 1.
/// 0 where they throw none.
double light_exposure(std::vector<Light> const& lights, Bounds const& box);

/// `lights` with that exposure, and one from all around; none at all for an exposure of 0.
std::vector<Light> exposed_lights(std::vector<Light> const& lights, double exposure);

}  // namespace lichtraum::gltf
