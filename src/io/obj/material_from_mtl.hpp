#pragma once

#include "io/obj/made_pictures.hpp"
#include "io/obj/mtl_file.hpp"
#include "lichtraum/material.hpp"

namespace lichtraum::obj {

/// Phong's model with MTL's own coefficients; or, where these are physically based ones, where pictures or the
/// vertices' colours change them from point to point, and where nothing is there at all, glTF's model that is nearest
/// to them (docs/MODELS.md).
std::shared_ptr<Material> material_from_mtl(MtlMaterial const& source, bool has_colors, MadePictures& made);

}  // namespace lichtraum::obj
