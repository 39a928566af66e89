#pragma once

#include <array>
#include <glm/geometric.hpp>
#include <vector>

#include "lichtraum/scene.hpp"
#include "scene/flatten.hpp"

namespace lichtraum::testing {

using Corners = std::array<Vec3, 3>;

/// Every triangle that a scene draws, in the world, instances unfolded.
inline std::vector<Corners> world_triangles(Scene const& scene) {
  FlatScene const flat = flatten(scene.roots());
  std::vector<Corners> result;
  auto const add = [&](FlatObject const& object, Transform const& transform) {
    for (auto const& t : object.triangles) {
      auto const corner = [&](int i) {
        return transform.point({t.vertices[i][0], t.vertices[i][1], t.vertices[i][2]});
      };
      result.push_back({corner(0), corner(1), corner(2)});
    }
  };
  add(flat.objects[0], Transform());
  for (auto const& instance : flat.instances) add(flat.objects[instance.object], instance.world_from_object);
  return result;
}

/// Whether the corners are the same in the same sense of rotation, whichever is the first.
inline bool is_same_triangle(Corners const& a, Corners const& b, double tolerance) {
  for (std::size_t shift = 0; shift < 3; ++shift) {
    bool all = true;
    for (std::size_t i = 0; i < 3; ++i) all = all && glm::distance(a[i], b[(i + shift) % 3]) <= tolerance;
    if (all) return true;
  }
  return false;
}

}  // namespace lichtraum::testing
