#pragma once

#include "lichtraum/api.hpp"

namespace LICHTRAUM_API lichtraum {

/// From unbounded radiance to a displayable range (kernels/shared/tone_map.h has the formulas). Linear, both of Rec.
/// 709's primaries.
enum class ToneMap {
  automatic,  ///< what the scene says
  none,       ///< as computed; clamped to [0, 1] when the picture is quantised
  reinhard,   ///< c / (c + 1) per channel (Reinhard et al. 2002, eq. 3)
  neutral,    ///< Khronos PBR Neutral: base colours stay as they are, highlights fade to white
  agx,        ///< AgX: low contrast, bright colours fade as on film
  aces,       ///< Hill's fit of ACES: high contrast, dark shadows
};

/// From linear values to stored ones.
enum class Transfer {
  linear,  ///< as computed: the course's pictures
  srgb,    ///< IEC 61966-2-1
};

}  // namespace lichtraum
