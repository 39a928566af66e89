#include "scene/lowest_point.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>

namespace lichtraum {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

Vec3 vec3(float const (&p)[3]) { return {p[0], p[1], p[2]}; }

/// A linear function of points: dot(direction, p) + offset.
struct Height {
  Vec3 direction;
  double offset = 0;
  double operator()(Vec3 const& p) const { return glm::dot(direction, p) + offset; }
};

/// The same of points in the frame that `frame_from_object` maps to.
Height in_frame(Height const& height, device::AffineTransform const& t) {
  Mat3 const rows(Vec3(t.row_x.x, t.row_x.y, t.row_x.z), Vec3(t.row_y.x, t.row_y.y, t.row_y.z),
                  Vec3(t.row_z.x, t.row_z.y, t.row_z.z));
  Vec3 const direction = glm::inverse(rows) * height.direction;  // the transpose's inverse, as glm's columns are rows
  return {direction, height.offset - glm::dot(direction, Vec3(t.row_x.w, t.row_y.w, t.row_z.w))};
}

double across(Height const& height) { return std::hypot(height.direction.x, height.direction.z); }

// The least height of a primitive's points.
double least(device::TrianglePrimitive const& triangle, Height const& height) {
  return std::min(
      {height(vec3(triangle.vertices[0])), height(vec3(triangle.vertices[1])), height(vec3(triangle.vertices[2]))});
}
double least(device::SpherePrimitive const& sphere, Height const& height) {
  return height(vec3(sphere.center)) - sphere.radius * glm::length(height.direction);
}
double least(device::BoxPrimitive const& box, Height const& height) {
  Height const own = in_frame(height, box.box_from_object);
  Vec3 corner;
  for (int i = 0; i < 3; ++i) corner[i] = own.direction[i] < 0 ? box.max[i] : box.min[i];
  return own(corner);
}
double least(device::EllipsoidPrimitive const& ellipsoid, Height const& height) {
  Height const own = in_frame(height, ellipsoid.unit_from_object);
  return own.offset - glm::length(own.direction);
}
double least(device::CylinderPrimitive const& cylinder, Height const& height) {
  Height const own = in_frame(height, cylinder.unit_from_object);
  return own.offset + std::min(own.direction.y, 0.0) - across(own);
}
double least(device::ConePrimitive const& cone, Height const& height) {
  Height const own = in_frame(height, cone.unit_from_object);
  return own.offset + std::min(own.direction.y, -across(own));
}
double least(device::PlanePrimitive const&, Height const&) { return infinity; }

double least(FlatObject const& object, Height const& height) {
  double result = infinity;
  device::for_each_kind(object, [&](auto const& primitives) {
    for (auto const& primitive : primitives) result = std::min(result, least(primitive, height));
  });
  return result;
}

/// Around an object, in its own frame.
struct ObjectBox {
  Vec3 min, max;
  explicit ObjectBox(FlatObject const& object) {
    for (int i = 0; i < 3; ++i) {
      Vec3 axis(0);
      axis[i] = 1;
      min[i] = least(object, {axis});
      max[i] = -least(object, {-axis});
    }
  }
  double least_of(Height const& height) const {
    Vec3 corner;
    for (int i = 0; i < 3; ++i) corner[i] = height.direction[i] < 0 ? max[i] : min[i];
    return height(corner);
  }
};

}  // namespace

double lowest_point(FlatScene const& scene, Vec3 const& up) {
  if (scene.objects.empty()) return infinity;
  double lowest = least(scene.objects.front(), {up});
  if (scene.instances.empty()) return lowest;
  std::vector<ObjectBox> const boxes(scene.objects.begin() + 1, scene.objects.end());  // instances show no world
  for (FlatInstance const& instance : scene.instances) {
    FlatObject const& object = scene.objects[instance.object];
    if (object.primitive_count() == 0) continue;
    Vec3 direction;
    for (int i = 0; i < 3; ++i) {
      Vec3 axis(0);
      axis[i] = 1;
      direction[i] = glm::dot(instance.world_from_object.vector(axis), up);
    }
    Height const height{direction, glm::dot(instance.world_from_object.point(Vec3(0)), up)};
    // Most are not worth a look at all of their primitives.
    if (boxes[instance.object - 1].least_of(height) < lowest) lowest = std::min(lowest, least(object, height));
  }
  return lowest;
}

}  // namespace lichtraum
