#pragma once

#include "lichtraum/transform.hpp"
#include "shared/geometry.h"

namespace lichtraum {

/// Between the host's double precision and the device's structs. Values too large for a float become infinite.

inline void store(Vec3 const& v, float (&out)[3]) {
  for (int axis = 0; axis < 3; ++axis) out[axis] = float(v[axis]);
}

inline device::float4 device_float4(Vec3 const& v, double w = 0) {
  return {float(v.x), float(v.y), float(v.z), float(w)};
}

inline device::AffineTransform device_transform(Transform const& t) {
  Mat4 const rows = glm::transpose(t.matrix());
  return {device_float4(Vec3(rows[0]), rows[0].w), device_float4(Vec3(rows[1]), rows[1].w),
          device_float4(Vec3(rows[2]), rows[2].w)};
}

/// Throws std::invalid_argument when the map has no inverse.
inline Transform host_transform(device::AffineTransform const& t) {
  auto const row = [](device::float4 const& r) { return glm::dvec4(r.x, r.y, r.z, r.w); };
  return Transform::from_matrix(glm::transpose(Mat4(row(t.row_x), row(t.row_y), row(t.row_z), glm::dvec4(0, 0, 0, 1))));
}

}  // namespace lichtraum
