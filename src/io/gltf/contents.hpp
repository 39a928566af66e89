#pragma once

#include "io/gltf/accessors.hpp"
#include "lichtraum/model.hpp"

namespace lichtraum::gltf {

/// The time of an animation's last key frame.
double animation_seconds(tinygltf::Animation const& animation, Accessors& accessors, std::string const& pointer);

/// The extensions, animations, scenes and variants of a model. Reads the animations' times through `accessors`.
ModelContents describe_contents(tinygltf::Model const& model, Accessors& accessors);

}  // namespace lichtraum::gltf
