#include "lichtraum/turntable.hpp"

#include "scene/drawn_roots.hpp"
#include "scene/graph_fold.hpp"

namespace lichtraum {
namespace {

/// Whether the box reaches past the point to all four sides, seen from above.
bool surrounds(Bounds const& bounds, Vec3 const& point) {
  return bounds.min.x < point.x && point.x < bounds.max.x && bounds.min.z < point.z && point.z < bounds.max.z;
}

}  // namespace

// A composite that is shown several times counts as one thing: there may be more paths below it than anyone can walk.
Bounds bounds_of_interest(Scene const& scene, std::string_view root, Camera const& camera) {
  Vec3 const eye = camera.world_from_camera().point(Vec3(0));
  auto const roots = drawn_roots(scene, root);
  GraphOrder const order = order_graph(roots);
  auto const bounds = fold_bounds(roots);
  Bounds everything, of_interest;
  struct Pending {
    Shape const* shape;
    Transform world_from_parent;
  };
  std::vector<Pending> pending;
  for (auto const& shape : roots) pending.push_back({shape.get(), Transform()});
  while (!pending.empty()) {
    auto const [shape, world_from_parent] = pending.back();
    pending.pop_back();
    Transform const world_from_shape = world_from_parent * shape->world_from_object();
    Composite const* const composite = as_composite(*shape);
    if (composite && order[shape].occurrences == 1) {
      for (auto const& child : composite->children()) pending.push_back({child.get(), world_from_shape});
      continue;
    }
    Bounds const box = mapped(world_from_shape, bounds.of(*shape));
    if (!box.is_finite()) continue;
    everything.add(box);
    if (!surrounds(box, eye)) of_interest.add(box);
  }
  return of_interest.is_empty() ? everything : of_interest;
}

Vec3 center_of_interest(Scene const& scene, std::string_view root, Camera const& camera) {
  Bounds const box = bounds_of_interest(scene, root, camera);
  return box.is_empty() ? Vec3(0) : box.center();
}

Camera orbited(Camera const& camera, Vec3 const& center, double degrees, Vec3 const& up) {
  Camera result = camera;
  Transform const turn =
      Transform::translation(center) * Transform::rotation(degrees, up) * Transform::translation(-center);
  result.set_world_from_camera(turn * camera.world_from_camera());
  return result;
}

}  // namespace lichtraum
