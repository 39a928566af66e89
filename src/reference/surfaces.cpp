#include "reference/surfaces.hpp"

#include <algorithm>
#include <limits>

#include "reference/integrator.hpp"
#include "reference/point.hpp"
#include "reference/scattering_point.hpp"
#include "scene/graph_order.hpp"

namespace lichtraum {

ReferenceSurfaces::ReferenceSurfaces(ReferenceScene const& scene, ReferenceNumbers const& numbers,
                                     PlaneSet const& planes)
    : scene_(scene), numbers_(numbers) {
  if (planes.has(FilmPlane::object) || planes.has(FilmPlane::instance)) list_objects();
}

void ReferenceSurfaces::list_objects() {
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

std::uint64_t ReferenceSurfaces::object_number(Ray const& ray) const {
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

FirstSurface ReferenceSurfaces::sample(Ray const& ray) const {
  Hit hit;
  if (!find_closest(scene_, ray, 0, hit)) return {};
  ReferencePoint const point = find_reference_point(ray, hit);
  double const straight = point.phong.reflect + point.phong.transmit;
  Rgb const shown = (1 - straight) * point.phong.kd + point.phong.ks + straight;
  return {1, glm::min(shown, Rgb(1)), point.normal};
}

ReferenceSurfaces::Center ReferenceSurfaces::center(Ray const& camera_ray, Integrator integrator) const {
  Ray ray = camera_ray;
  Hit hit;
  Center center;
  for (;;) {
    hit = Hit();
    if (!find_closest(scene_, ray, 0, hit)) return center;
    if (integrator != Integrator::path) break;
    ReferenceScatteringPoint const point = find_scattering_point(ray, hit);
    if (point.from_outside || point.shows_back) break;
    ray = {point.below(), ray.direction};
  }
  center.position = ray.at(hit.t);
  center.depth = glm::distance(camera_ray.origin, center.position);
  center.material = numbers_.materials.at(hit.shape->material().get());
  if (!leaves_.empty()) {
    std::uint64_t const object = object_number(ray);
    auto const instance = numbers_.objects.instance_of(object);
    center.object = std::uint32_t(std::min<std::uint64_t>(object, std::numeric_limits<std::uint32_t>::max()));
    center.instance = instance ? *instance + 1 : 0;
  }
  return center;
}

}  // namespace lichtraum
