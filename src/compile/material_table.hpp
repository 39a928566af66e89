#pragma once

#include <memory>
#include <vector>

#include "core/big_vector.hpp"
#include "lichtraum/material.hpp"
#include "shared/pbr_material.h"
#include "shared/phong_material.h"

namespace lichtraum {

/// Materials and their textures as the kernels read them.
struct MaterialTable {
  BigVector<device::PhongMaterial> phong;
  BigVector<device::PbrMaterial> pbr;  ///< as many, or none where no material has one
  BigVector<device::Texture> textures;
  BigVector<device::uint> texels;  ///< RGBA8, each picture once
  device::uint features = 0;       ///< SCENE_...
};

device::PhongMaterial phong_material(Material const& material);
/// With the textures of the entry that it had before.
device::PbrMaterial pbr_material(PbrModel const& model, device::PbrMaterial const& before);
/// The SCENE_... that a scene has for a material's sake.
device::uint features_of(Material const& material);

/// A null material is the default one. Throws Error{scene} for more than 2^32 texels.
MaterialTable make_material_table(std::vector<std::shared_ptr<Material const>> const& materials);

}  // namespace lichtraum
