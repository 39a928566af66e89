#pragma once

#include "lichtraum/pbr_model.hpp"
#include "lichtraum/phong_model.hpp"
#include "scene/mesh_point.hpp"
#include "scene/texture_lookup.hpp"
#include "shared/phong_from_pbr.h"

namespace lichtraum {

/// Whether textures change what a material is from point to point; normal maps do not count.
bool varies(PbrModel const& material);
/// The same of what its Phong coefficients know nothing of: sheen, anisotropy, diffuse transmission.
bool varies_more(PbrModel const& material);
/// Whether a ray may go through a surface because nothing is there: alpha masks, and what blends.
bool has_cutouts(PbrModel const& material);
/// Whether textures or vertices decide how much light it lets through.
bool filters(PbrModel const& material);

/// Whether light may go straight on through it in some points: a smooth wall without thickness that has nothing on it
/// and does not shine.
bool may_be_pane(PbrModel const& material);

/// What a slot shows at a point: all ones where it is empty, or where the mesh lacks its texture coordinates.
glm::dvec4 texel_at(TextureSlot const& slot, MeshPoint const& point, TexelContent content);

/// Whether light needs to know how textures lie on a surface: anisotropy does, and a coat whose normal is not the
/// base's.
bool needs_tangents(PbrModel const& material);

/// Alpha, whatever the mode makes of it: factor times texture times vertex colour.
double base_alpha(PbrModel const& material, MeshPoint const& point);
/// Whether nothing is there where alpha is this: below a mask's cutoff, or where what blends is wholly transparent.
bool is_cut_out(PbrModel const& material, double alpha);

/// The material at a point: its factors, its textures and the vertices' colours multiplied.
device::PbrPoint evaluate(PbrModel const& material, MeshPoint const& point);
/// Phong's coefficients there, derived from that by the mapping in docs/GLTF.md.
PhongModel phong_at(PbrModel const& material, MeshPoint const& point);

}  // namespace lichtraum
