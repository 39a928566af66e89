#pragma once

#include <iosfwd>
#include <iterator>
#include <limits>
#include <memory>
#include <string>
#include <string_view>

#include "lichtraum/api.hpp"
#include "lichtraum/bounds.hpp"
#include "lichtraum/material.hpp"
#include "lichtraum/ray.hpp"
#include "lichtraum/transform.hpp"

namespace LICHTRAUM_API lichtraum {

class Shape;
class ShapeVisitor;

enum class ShapeKind { sphere, box, triangle, cylinder, cone, plane, mesh, point_cloud, line_set, composite };
inline constexpr std::size_t shape_kind_count = std::size_t(ShapeKind::composite) + 1;

/// As in eSDF, which has no word for point clouds and line sets: they are parts of models.
inline constexpr std::string_view shape_kind_names[] = {"sphere", "box",  "triangle",    "cylinder", "cone",
                                                        "plane",  "mesh", "point cloud", "line set", "composite"};
static_assert(std::size(shape_kind_names) == shape_kind_count);
constexpr std::string_view name_of(ShapeKind kind) { return shape_kind_names[std::size_t(kind)]; }

/// Where a ray meets a surface.
struct Hit {
  double t = std::numeric_limits<double>::infinity();  ///< in units of the ray's direction
  Vec3 normal{0};                                      ///< geometric, unit length, outward (triangle: by its winding)
  Shape const* shape = nullptr;                        ///< the sphere, box and so on, never the composite above
  std::size_t triangle = 0;  ///< of a mesh: the triangle's number; of points: the point's; of lines: the line's
  Vec3 barycentric{0};  ///< of a mesh: the weights of that triangle's corners, which sum to 1; of lines: of both ends
  Mat3 linear_from_shape{1};  ///< maps directions of the shape's own frame to those of the ray's
};

/// A node of the scene graph (the composite pattern's component). A shape may be a child of several composites, or
/// several times of one: the graph is acyclic, and every path from a root to a leaf draws that leaf once.
///
/// closest_hit and intersect are a working reference tracer, in double precision and without any acceleration
/// structure: what the device kernels are tested against.
class Shape {
 public:
  virtual ~Shape() = default;
  Shape(Shape const&) = delete;
  Shape& operator=(Shape const&) = delete;

  std::string const& name() const { return name_; }
  /// Null for a composite, whose children have their own.
  std::shared_ptr<Material const> const& material() const { return material_; }

  /// From this shape's own frame to its parent's: the composite's that names it, or the world's for a root.
  Transform const& world_from_object() const;
  Transform object_from_world() const { return world_from_object().inverse(); }

  /// Each applies after what was applied before, in the parent's frame: world_from_object' = T * world_from_object.
  /// Same exceptions as the functions of Transform.
  void translate(Vec3 const& offset) { apply(Transform::translation(offset)); }
  void rotate(double angle_degrees, Vec3 const& axis) { apply(Transform::rotation(angle_degrees, axis)); }
  void scale(double factor) { apply(Transform::scaling(Vec3(factor))); }
  void scale(Vec3 const& factors) { apply(Transform::scaling(factors)); }
  void apply(Transform const& t);
  void set_world_from_object(Transform const& t);

  virtual ShapeKind kind() const = 0;

  /// A box around all of it, in its own frame. Empty for a composite, whose children have theirs; infinite for a plane.
  virtual Bounds bounds() const = 0;

  /// Whether the ray (in the parent's frame) hits; then `t` is the distance to the nearest hit in front of its origin,
  /// in units of the direction's length. Without a hit `t` is not touched.
  virtual bool intersect(Ray const& ray, float& t) const = 0;

  /// The same in double precision with the surface's normal, for hits with t_min < t < hit.t; `hit` is only changed
  /// when the result is true. Ray and hit are in the parent's frame.
  virtual bool closest_hit(Ray const& ray, double t_min, Hit& hit) const = 0;

  virtual void accept(ShapeVisitor& visitor) const = 0;

  /// The same shape of another material, with the same name in the same place. A mesh shares its geometry, a composite
  /// its children.
  std::shared_ptr<Shape> copy(std::shared_ptr<Material const> material) const;

 protected:
  Shape(std::string name, std::shared_ptr<Material const> material)
      : name_(std::move(name)), material_(std::move(material)) {}

  /// The ray in this shape's own frame; its direction is not normalised, so t means the same in both.
  Ray object_from_world(Ray const& ray) const;

 private:
  friend std::ostream& operator<<(std::ostream& out, Shape const& shape);

  /// What operator<< says between the name and the material.
  virtual std::string description() const = 0;
  /// A copy at the origin.
  virtual std::shared_ptr<Shape> remake(std::shared_ptr<Material const> material) const = 0;

  std::string name_;
  std::shared_ptr<Material const> material_;
  std::unique_ptr<Transform> world_from_object_;  // null is the identity: most of a million triangles never move
};

std::ostream& operator<<(std::ostream& out, Shape const& shape);

}  // namespace lichtraum
