#pragma once

#include "lichtraum/material.hpp"

namespace lichtraum::gltf {

/// Phong coefficients that look like `pbr` under Whitted's integrator, by the mapping in docs/GLTF.md. The material
/// keeps `pbr`. Textures count as all ones: what they change is derived again at each point of a mesh.
Material phong_from_pbr(std::string name, std::shared_ptr<PbrMaterial const> pbr);

}  // namespace lichtraum::gltf
