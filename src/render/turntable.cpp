#include "lichtraum/turntable.hpp"

#include <unordered_map>

#include "accel/primitive_bounds.hpp"
#include "render/drawn_roots.hpp"
#include "scene/flatten.hpp"

namespace lichtraum {
namespace {

/// Whether the box reaches past the point to all four sides, seen from above.
bool surrounds(Bounds const& bounds, Vec3 const& point) {
  return double(bounds.min[0]) < point.x && point.x < double(bounds.max[0]) && double(bounds.min[2]) < point.z &&
         point.z < double(bounds.max[2]);
}

template <class Primitive>
void add_bounds(std::vector<Primitive> const& primitives, std::unordered_map<device::uint, Bounds>& by_shape) {
  for (Primitive const& primitive : primitives) {
    Bounds const bounds = bounds_of(primitive);
    if (bounds.is_finite()) by_shape[primitive.tag.shape].add(bounds);
  }
}

/// Around each shape of an object, in the object's frame.
std::unordered_map<device::uint, Bounds> bounds_by_shape(FlatObject const& object) {
  std::unordered_map<device::uint, Bounds> by_shape;
  add_bounds(object.triangles, by_shape);
  add_bounds(object.spheres, by_shape);
  add_bounds(object.ellipsoids, by_shape);
  add_bounds(object.boxes, by_shape);
  return by_shape;
}

}  // namespace

Vec3 center_of_interest(Scene const& scene, std::string_view root, Camera const& camera) {
  Vec3 const eye = camera.world_from_camera().point(Vec3(0));
  Bounds everything, of_interest;
  auto const include = [&](Bounds const& bounds) {
    if (!bounds.is_finite()) return;
    everything.add(bounds);
    if (!surrounds(bounds, eye)) of_interest.add(bounds);
  };
  FlatScene const flat = flatten(drawn_roots(scene, root));
  for (auto const& [shape, bounds] : bounds_by_shape(flat.objects[0])) include(bounds);
  std::vector<Bounds> object_bounds(flat.objects.size());
  for (std::size_t i = 1; i < flat.objects.size(); ++i) {
    for (auto const& [shape, bounds] : bounds_by_shape(flat.objects[i])) object_bounds[i].add(bounds);
  }
  for (FlatInstance const& instance : flat.instances) {
    include(map_bounds(instance.world_from_object, object_bounds[instance.object]));
  }
  Bounds const& box = of_interest.is_empty() ? everything : of_interest;
  return box.is_empty() ? Vec3(0) : Vec3(box.center(0), box.center(1), box.center(2));
}

Camera orbited(Camera const& camera, Vec3 const& center, double degrees) {
  Camera result = camera;
  Transform const turn =
      Transform::translation(center) * Transform::rotation(degrees, Vec3(0, 1, 0)) * Transform::translation(-center);
  result.set_world_from_camera(turn * camera.world_from_camera());
  return result;
}

}  // namespace lichtraum
