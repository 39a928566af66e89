#pragma once

#include <cmath>

#include "lichtraum/mesh_geometry.hpp"

namespace lichtraum {

inline Vec3 to_vec3(Float3 const& p) { return {p[0], p[1], p[2]}; }
inline Float3 to_float3(Vec3 const& p) { return {float(p.x), float(p.y), float(p.z)}; }
inline bool is_finite(Vec3 const& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }
inline bool is_finite(Float3 const& p) { return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]); }

}  // namespace lichtraum
