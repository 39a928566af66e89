#pragma once

#include "io/obj/mtl_file.hpp"
#include "io/obj/packed_pictures.hpp"
#include "lichtraum/material.hpp"

namespace lichtraum::obj {

/// A material's pictures, decoded; null where there are none.
struct MtlTextures {
  std::shared_ptr<TextureImage const> map_kd, map_ke, map_d, map_pr, map_pm, norm;
};

/// Phong's model with MTL's own coefficients; or, where these are physically based ones, where pictures or the
/// vertices' colours change them from point to point, and where nothing is there at all, glTF's model that is nearest
/// to them (docs/MODELS.md).
std::shared_ptr<Material> material_from_mtl(MtlMaterial const& source, MtlTextures const& textures, bool has_colors,
                                            PackedPictures& packed);

}  // namespace lichtraum::obj
