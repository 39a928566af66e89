#pragma once

#include "lichtraum/pbr_material.hpp"
#include "scene/mesh_point.hpp"
#include "shared/phong_from_pbr.h"

namespace lichtraum {

/// Whether textures change what a material is from point to point; normal maps do not count.
bool varies(PbrMaterial const& material);
/// Whether a ray may go through a surface because nothing is there: alpha masks, and what blends.
bool has_cutouts(PbrMaterial const& material);
/// Whether textures or vertices decide how much light it lets through.
bool filters(PbrMaterial const& material);

/// Alpha, whatever the mode makes of it: factor times texture times vertex colour.
double base_alpha(PbrMaterial const& material, MeshPoint const& point);
/// Whether nothing is there where alpha is this: below a mask's cutoff, or where what blends is wholly transparent.
bool is_cut_out(PbrMaterial const& material, double alpha);

/// The material at a point: its factors, its textures and the vertices' colours multiplied. What Phong's coefficients
/// are derived from.
device::PbrPoint evaluate(PbrMaterial const& material, MeshPoint const& point);

}  // namespace lichtraum
