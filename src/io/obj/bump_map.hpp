#pragma once

#include "lichtraum/pbr_model.hpp"

namespace lichtraum::obj {

/// Whether a picture that MTL calls a bump map is a normal map in tangent space, as Blender's exporter names these:
/// most of its normals point away from the surface, so that it is blue.
bool is_normal_map(TextureImage const& picture);

/// The normal map (glTF's: y points up in the picture) of heights, which are told by how bright a pixel is. Between
/// black and white are `multiplier` times 2 % of the picture's longer side, whatever its resolution; MTL names no unit,
/// and this one is that of the G3D engine (BumpMapPreprocess, McGuire). Slopes are Sobel's, which smooth the steps of 8
/// bits. `is_clamped`: edges go on as they are, else on the other side.
TextureImage normals_from_heights(TextureImage const& heights, double multiplier, bool is_clamped);

}  // namespace lichtraum::obj
