#pragma once

#include "io/obj/mtl_file.hpp"
#include "lichtraum/material.hpp"

namespace lichtraum::obj {

/// A material's pictures, decoded; null where there are none.
struct MtlTextures {
  std::shared_ptr<TextureImage const> map_kd, map_ke, norm;
};

/// Phong's coefficients are MTL's own; docs/MODELS.md says what becomes of the others. The pictures, and what a
/// physically based integrator needs, are in Material::pbr().
std::shared_ptr<Material> phong_from_mtl(MtlMaterial const& source, MtlTextures const& textures);

}  // namespace lichtraum::obj
