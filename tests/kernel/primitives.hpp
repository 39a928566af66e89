#pragma once

#include "reference.hpp"
#include "shared/geometry.h"

namespace lichtraum::test {

inline device::TrianglePrimitive make_triangle(Vec3 const& a, Vec3 const& b, Vec3 const& c, device::uint material = 0) {
  device::TrianglePrimitive p{};
  for (int i = 0; i < 3; ++i) {
    p.vertices[0][i] = float(a[i]);
    p.vertices[1][i] = float(b[i]);
    p.vertices[2][i] = float(c[i]);
  }
  p.tag.material = material;
  return p;
}

inline device::SpherePrimitive make_sphere(Vec3 const& center, double radius, device::uint material = 0) {
  return {{float(center.x), float(center.y), float(center.z)}, float(radius), {material, 0}};
}

inline device::EllipsoidPrimitive make_ellipsoid(Affine const& object_from_unit, device::uint material = 0) {
  return {to_device(object_from_unit.inverse()), {material, 0}, {0, 0}};
}

template <class UnitPrimitive>
UnitPrimitive make_unit_shape(Affine const& object_from_unit) {
  UnitPrimitive p{};
  p.unit_from_object = to_device(object_from_unit.inverse());
  return p;
}

inline device::BoxPrimitive make_box(Affine const& object_from_box, Vec3 const& min, Vec3 const& max,
                                     device::uint material = 0) {
  device::BoxPrimitive p{};
  p.box_from_object = to_device(object_from_box.inverse());
  for (int i = 0; i < 3; ++i) {
    p.min[i] = float(min[i]);
    p.max[i] = float(max[i]);
  }
  p.tag.material = material;
  return p;
}

}  // namespace lichtraum::test
