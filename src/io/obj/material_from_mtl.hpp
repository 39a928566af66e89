#pragma once

#include "io/obj/made_pictures.hpp"
#include "io/obj/mtl_file.hpp"
#include "lichtraum/material.hpp"

namespace lichtraum::obj {

/// What a material is read for.
struct MtlUse {
  bool has_colors = false;        ///< the vertices have some
  bool is_part_of_scene = false;  ///< see ModelOptions
};

/// Phong's model with MTL's own coefficients; or, where these are physically based ones, where pictures or the
/// vertices' colours change them from point to point, where nothing is there at all, and where it is neither mirror
/// nor glass and no part of a scene, glTF's model that is nearest to them (docs/MODELS.md).
std::shared_ptr<Material> material_from_mtl(MtlMaterial const& source, MtlUse const& use, MadePictures& made);

}  // namespace lichtraum::obj
