#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "core/float3.hpp"
#include "lichtraum/shapes.hpp"
#include "scene/hit_triangle.hpp"
#include "scene/leaf_hit.hpp"

namespace lichtraum {
namespace {

void check(MeshGeometry const& geometry) {
  std::size_t const count = geometry.positions.size();
  auto const fits = [count](auto const& attribute) { return attribute.empty() || attribute.size() == count; };
  bool const all_fit = fits(geometry.normals) && fits(geometry.tangents) && fits(geometry.colors) &&
                       std::all_of(geometry.texcoords.begin(), geometry.texcoords.end(), fits);
  if (!all_fit) throw std::invalid_argument("a mesh needs as many elements of each attribute as positions");
  if (geometry.indices.size() % 3 != 0) throw std::invalid_argument("a mesh needs three indices per triangle");
  std::uint32_t largest = 0;
  for (std::uint32_t const index : geometry.indices) largest = std::max(largest, index);
  if (!geometry.indices.empty() && largest >= count) throw std::invalid_argument("an index of a mesh is out of range");
}

/// Whether the ray meets the box with t_min <= t <= t_max (slabs: Kay and Kajiya 1986). A NaN counts as met: the box is
/// only there to save time.
bool may_hit_box(Ray const& ray, Bounds const& box, double t_min, double t_max) {
  for (int axis = 0; axis < 3; ++axis) {
    double near = (box.min[axis] - ray.origin[axis]) / ray.direction[axis];
    double far = (box.max[axis] - ray.origin[axis]) / ray.direction[axis];
    if (near > far) std::swap(near, far);
    // A few rounding errors of slack, so that the box is no smaller than the triangles in it.
    constexpr double slack = 1e-14;
    near -= slack * std::abs(near);
    far += slack * std::abs(far);
    if (near > t_min) t_min = near;
    if (far < t_max) t_max = far;
  }
  return !(t_min > t_max);
}

}  // namespace

std::array<Vec3, 3> MeshGeometry::triangle(std::size_t number) const {
  std::uint32_t const* const corners = &indices[3 * number];
  return {to_vec3(positions[corners[0]]), to_vec3(positions[corners[1]]), to_vec3(positions[corners[2]])};
}

Bounds MeshGeometry::bounds() const {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  Float3 min{infinity, infinity, infinity};
  Float3 max{-infinity, -infinity, -infinity};
  auto const add = [&](Float3 const& p) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      // An infinity is on the wrong side of neither comparison; nor is a NaN.
      if (p[axis] < min[axis] && p[axis] > -infinity) min[axis] = p[axis];
      if (p[axis] > max[axis] && p[axis] < infinity) max[axis] = p[axis];
    }
  };
  for (std::uint32_t const number : indices) add(positions[number]);
  if (indices.empty()) std::ranges::for_each(positions, add);
  return {to_vec3(min), to_vec3(max)};
}

Mesh::Mesh(std::string name, std::shared_ptr<MeshGeometry const> geometry, std::shared_ptr<Material const> material)
    : Shape(std::move(name), std::move(material)), geometry_(std::move(geometry)) {
  if (!geometry_) throw std::invalid_argument("a mesh needs a geometry");
  check(*geometry_);
  bounds_ = geometry_->bounds();
}

bool Mesh::closest_hit(Ray const& ray, double t_min, Hit& hit) const {
  Ray const local = object_from_world(ray);
  if (!may_hit_box(local, bounds_, t_min, hit.t)) return false;
  TriangleHit found{hit.t, Vec3(0), Vec3(0)};
  std::size_t const none = geometry_->triangle_count();
  std::size_t nearest = none;
  for (std::size_t i = 0; i < geometry_->triangle_count(); ++i) {
    if (hit_triangle(local, geometry_->triangle(i), t_min, found)) nearest = i;
  }
  if (nearest == none) return false;
  hit = leaf_hit(*this, found.t, found.normal);
  hit.triangle = nearest;
  hit.barycentric = found.barycentric;
  return true;
}

bool Mesh::intersect(Ray const& ray, float& t) const { return intersect_closest(*this, ray, t); }

void Mesh::accept(ShapeVisitor& visitor) const { visitor.visit(*this); }

std::string Mesh::description() const {
  std::size_t const count = geometry_->triangle_count();
  return fmt::format("{} {}", count, count == 1 ? "triangle" : "triangles");
}

std::shared_ptr<Shape> Mesh::remake(std::shared_ptr<Material const> material) const {
  return std::make_shared<Mesh>(name(), geometry_, std::move(material));
}

}  // namespace lichtraum
