#include "lichtraum/turntable.hpp"

#include <algorithm>
#include <vector>

#include "scene/drawn_roots.hpp"
#include "scene/graph_fold.hpp"

namespace lichtraum {
namespace {

/// Whether the box reaches past the point to all four sides, seen from above.
bool surrounds(Bounds const& bounds, Vec3 const& point) {
  return bounds.min.x < point.x && point.x < bounds.max.x && bounds.min.z < point.z && point.z < bounds.max.z;
}

/// The boxes around all shapes that end somewhere. A composite that is shown several times counts as one thing: there
/// may be more paths below it than anyone can walk.
std::vector<Bounds> boxes_of(Scene const& scene, std::string_view root) {
  auto const roots = drawn_roots(scene, root);
  GraphOrder const order = order_graph(roots);
  auto const bounds = fold_bounds(roots);
  std::vector<Bounds> boxes;
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
    if (box.is_finite()) boxes.push_back(box);
  }
  return boxes;
}

Bounds box_around(std::vector<Bounds> const& boxes) {
  Bounds all;
  for (Bounds const& box : boxes) all.add(box);
  return all;
}

double width_of(Bounds const& box) { return std::min(box.max.x - box.min.x, box.max.z - box.min.z); }

/// Of all that `outer` surrounds: what lies in it as in a room, or on it or below it, as on a floor.
Bounds reach_of(Bounds const& outer) {
  constexpr double most_height = 0.2;  // of a floor, in its widths
  constexpr double infinity = Bounds::infinity;
  Bounds reach = outer;
  if (outer.max.y - outer.min.y <= most_height * width_of(outer)) {
    reach.min.y = -infinity;
    reach.max.y = infinity;
  }
  return reach;
}

bool lies_in(Bounds const& box, Bounds const& reach) {
  for (int axis = 0; axis < 3; ++axis) {
    if (box.min[axis] <= reach.min[axis] || reach.max[axis] <= box.max[axis]) return false;
  }
  return true;
}

}  // namespace

Bounds bounds_of_interest(Scene const& scene, std::string_view root, Camera const& camera) {
  Vec3 const eye = camera.world_from_camera().point(Vec3(0));
  auto const boxes = boxes_of(scene, root);
  Bounds of_interest;
  for (Bounds const& box : boxes) {
    if (!surrounds(box, eye)) of_interest.add(box);
  }
  return of_interest.is_empty() ? box_around(boxes) : of_interest;
}

Bounds bounds_of_interest(Scene const& scene, std::string_view root) {
  constexpr double least_width = 1.5;  // of what is left out, in widths of all that it surrounds: a chessboard stays
  auto boxes = boxes_of(scene, root);
  std::sort(boxes.begin(), boxes.end(), [](Bounds const& a, Bounds const& b) { return width_of(a) < width_of(b); });
  // Of the narrowest boxes, as few as all wider ones surround. `reaches[i]`: that of boxes i, i + 1 and so on.
  std::vector<Bounds> reaches(boxes.size());
  for (std::size_t i = boxes.size(); i-- > 0;) {
    reaches[i] = reach_of(boxes[i]);
    if (i + 1 == boxes.size()) continue;
    reaches[i].min = glm::max(reaches[i].min, reaches[i + 1].min);
    reaches[i].max = glm::min(reaches[i].max, reaches[i + 1].max);
  }
  Bounds inner;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    bool const is_much_wider =
        i > 0 && width_of(boxes[i]) >= least_width * std::max(inner.max.x - inner.min.x, inner.max.z - inner.min.z);
    if (is_much_wider && lies_in(inner, reaches[i])) return inner;
    inner.add(boxes[i]);
  }
  return inner;
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
