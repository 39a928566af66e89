#include "accel/primitive_bounds.hpp"

#include <cmath>

#include "scene/device_conversion.hpp"

namespace lichtraum {
namespace {

/// Matrices reach the device rounded to float: pad by what that can move a point.
constexpr double matrix_rounding = 1e-6;

Vec3 vec3(float const (&v)[3]) { return {v[0], v[1], v[2]}; }

DeviceBounds around(Vec3 const& center, Vec3 const& extent) {
  Vec3 const padded = extent + matrix_rounding * (extent + glm::abs(center));
  DeviceBounds bounds;
  add_point(bounds, center - padded);
  add_point(bounds, center + padded);
  return bounds;
}

/// The extent along each axis of the mapped box that reaches `extent` from its centre.
Vec3 mapped_extent(Mat3 const& m, Vec3 const& extent) {
  return glm::abs(m[0]) * extent.x + glm::abs(m[1]) * extent.y + glm::abs(m[2]) * extent.z;
}

/// How far the image of the unit disc in the plane y = 0 reaches along each axis from its centre.
Vec3 disc_extent(Transform const& object_from_unit) {
  Mat3 const m(object_from_unit.matrix());
  return {std::hypot(m[0].x, m[2].x), std::hypot(m[0].y, m[2].y), std::hypot(m[0].z, m[2].z)};
}

}  // namespace

DeviceBounds bounds_of(device::TrianglePrimitive const& triangle) {
  DeviceBounds bounds;
  for (auto const& vertex : triangle.vertices) bounds.add({vertex[0], vertex[1], vertex[2]});
  return bounds;
}

DeviceBounds bounds_of(device::SpherePrimitive const& sphere) {
  // The device finds hits up to its own rounding away from the exact sphere.
  return around(vec3(sphere.center), Vec3(sphere.radius));
}

DeviceBounds bounds_of(device::EllipsoidPrimitive const& ellipsoid) {
  Transform const object_from_unit = host_transform(ellipsoid.unit_from_object).inverse();
  // The image of the unit ball reaches as far along an axis as the matrix's row is long.
  Mat3 const rows = glm::transpose(Mat3(object_from_unit.matrix()));
  Vec3 const extent(glm::length(rows[0]), glm::length(rows[1]), glm::length(rows[2]));
  return around(object_from_unit.point(Vec3(0)), extent);
}

DeviceBounds bounds_of(device::BoxPrimitive const& box) {
  Transform const object_from_box = host_transform(box.box_from_object).inverse();
  Vec3 const min = vec3(box.min), max = vec3(box.max);
  Vec3 const extent = mapped_extent(Mat3(object_from_box.matrix()), 0.5 * (max - min));
  return around(object_from_box.point(0.5 * (min + max)), extent);
}

DeviceBounds bounds_of(device::CylinderPrimitive const& cylinder) {
  Transform const object_from_unit = host_transform(cylinder.unit_from_object).inverse();
  Vec3 const half_axis = 0.5 * object_from_unit.vector({0, 1, 0});
  return around(object_from_unit.point({0, 0.5, 0}), disc_extent(object_from_unit) + glm::abs(half_axis));
}

DeviceBounds bounds_of(device::ConePrimitive const& cone) {
  Transform const object_from_unit = host_transform(cone.unit_from_object).inverse();
  Vec3 const base = object_from_unit.point({0, 0, 0}), tip = object_from_unit.point({0, 1, 0});
  Vec3 const extent = disc_extent(object_from_unit);
  Vec3 const min = glm::min(base - extent, tip), max = glm::max(base + extent, tip);
  return around(0.5 * (min + max), 0.5 * (max - min));
}

DeviceBounds map_bounds(Transform const& world_from_object, DeviceBounds const& object_bounds) {
  if (object_bounds.is_empty()) return {};
  Vec3 const min(object_bounds.min), max(object_bounds.max);
  Vec3 const extent = mapped_extent(Mat3(world_from_object.matrix()), 0.5 * (max - min));
  return around(world_from_object.point(0.5 * (min + max)), extent);
}

}  // namespace lichtraum
