#include "render/reference_aov.hpp"

#include "render/reference_integrator.hpp"
#include "render/reference_point.hpp"
#include "scene/graph_order.hpp"

namespace lichtraum {

ReferenceAov::ReferenceAov(ReferenceScene const& scene, Aov aov) : scene_(scene), aov_(aov) {
  if (aov == Aov::object_id) list_objects();
}

void ReferenceAov::list_objects() {
  struct Pending {
    Shape const* shape;
    std::size_t parent;
  };
  world_from_parent_.assign(1, Transform());
  std::vector<Pending> pending;
  for (auto root = scene_.roots.rbegin(); root != scene_.roots.rend(); ++root) pending.push_back({root->get(), 0});
  while (!pending.empty()) {
    auto const [shape, parent] = pending.back();
    pending.pop_back();
    Composite const* const composite = as_composite(*shape);
    if (!composite) {
      leaves_.push_back({shape, parent});
      continue;
    }
    std::size_t const place = world_from_parent_.size();
    world_from_parent_.push_back(world_from_parent_[parent] * shape->world_from_object());
    auto const& children = composite->children();
    for (auto child = children.rbegin(); child != children.rend(); ++child) pending.push_back({child->get(), place});
  }
}

std::uint64_t ReferenceAov::object_number(Ray const& ray) const {
  double nearest = std::numeric_limits<double>::infinity();
  std::uint64_t number = 0;
  for (std::size_t i = 0; i < leaves_.size(); ++i) {
    Transform const& world_from_parent = world_from_parent_[leaves_[i].parent];
    Transform const parent_from_world = world_from_parent.inverse();
    Ray const local{parent_from_world.point(ray.origin), parent_from_world.vector(ray.direction)};
    double t_min = 0;
    for (;;) {
      Hit hit;
      hit.t = nearest;
      if (!leaves_[i].shape->closest_hit(local, t_min, hit)) break;
      if (!is_absent(hit)) {
        nearest = hit.t;
        number = i + 1;
        break;
      }
      t_min = hit.t;
    }
  }
  return number;
}

Rgb ReferenceAov::trace(Ray const& ray, RayCounts& counts) const {
  ++counts.camera;
  if (aov_ == Aov::object_id) {
    std::uint64_t const number = object_number(ray);
    counts.camera_hits += number != 0;
    return Rgb(double(number));
  }
  Hit hit;
  if (!find_closest(scene_, ray, 0, hit)) {
    return aov_ == Aov::depth ? Rgb(std::numeric_limits<double>::infinity()) : Rgb(0);
  }
  ++counts.camera_hits;
  return aov_ == Aov::depth ? Rgb(hit.t) : find_reference_point(ray, hit).normal;
}

}  // namespace lichtraum
