#include "io/obj/smooth_normals.hpp"

#include <algorithm>

#include "core/elementary.hpp"
#include "core/float3.hpp"

namespace lichtraum::obj {
namespace {

struct Triangle {
  std::uint32_t group;
  Corner* corners;
};

/// The triangles of smoothing groups that have a corner without a normal, group by group.
std::vector<Triangle> rough_triangles(ObjFile& file) {
  std::vector<Triangle> result;
  for (Part& part : file.parts) {
    for (std::size_t i = 0; i < part.smoothing_groups.size(); ++i) {
      Corner* const corners = &part.corners[3 * i];
      bool const is_rough = std::any_of(corners, corners + 3, [](Corner const& c) { return c.normal == Corner::none; });
      if (part.smoothing_groups[i] != 0 && is_rough) result.push_back({part.smoothing_groups[i], corners});
    }
  }
  std::ranges::stable_sort(result, {}, &Triangle::group);
  return result;
}

Vec3 unit_or_zero(Vec3 const& v) {
  double const length = glm::length(v);
  return length > 0 ? v / length : Vec3(0);
}

double angle_between(Vec3 const& a, Vec3 const& b) { return atan2_of(glm::length(glm::cross(a, b)), glm::dot(a, b)); }

}  // namespace

void add_smooth_normals(ObjFile& file) {
  std::vector<Triangle> const triangles = rough_triangles(file);
  if (triangles.empty()) return;
  std::vector<Vec3> sums;
  std::size_t const first = file.normals.size();
  std::vector<std::uint32_t> normal_of_position(file.positions.size(), Corner::none);
  std::size_t first_of_group = first;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (i > 0 && triangles[i].group != triangles[i - 1].group) first_of_group = first + sums.size();
    Vec3 points[3];
    for (int k = 0; k < 3; ++k) points[k] = to_vec3(file.positions[triangles[i].corners[k].position]);
    Vec3 const normal = unit_or_zero(glm::cross(points[1] - points[0], points[2] - points[0]));
    for (int k = 0; k < 3; ++k) {
      Corner& corner = triangles[i].corners[k];
      std::uint32_t& number = normal_of_position[corner.position];
      if (number == Corner::none || number < first_of_group) {
        number = std::uint32_t(first + sums.size());
        sums.emplace_back(0);
      }
      sums[number - first] += normal * angle_between(points[(k + 1) % 3] - points[k], points[(k + 2) % 3] - points[k]);
      if (corner.normal == Corner::none) corner.normal = number;
    }
  }
  file.normals.reserve(first + sums.size());
  for (Vec3 const& sum : sums) {
    Vec3 const n = unit_or_zero(sum);
    file.normals.push_back({float(n.x), float(n.y), float(n.z)});
  }
}

}  // namespace lichtraum::obj
