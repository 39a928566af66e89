#pragma once

/// The kinds of shape. Adding one: a class here, its file in src/scene/, a `visit` below, and the compiler names every
/// place that has to know it (what bakes it for the device).

#include <array>
#include <vector>

#include "lichtraum/api.hpp"
#include "lichtraum/mesh_geometry.hpp"
#include "lichtraum/shape.hpp"

namespace LICHTRAUM_API lichtraum {

class Sphere final : public Shape {
 public:
  /// `radius` > 0, all finite; else throws std::invalid_argument.
  Sphere(std::string name, Vec3 const& center, double radius, std::shared_ptr<Material const> material);
  Vec3 const& center() const { return center_; }
  double radius() const { return radius_; }

  ShapeKind kind() const override { return ShapeKind::sphere; }
  Bounds bounds() const override { return {center_ - radius_, center_ + radius_}; }
  bool intersect(Ray const& ray, float& t) const override;
  bool closest_hit(Ray const& ray, double t_min, Hit& hit) const override;
  void accept(ShapeVisitor& visitor) const override;

 private:
  std::string description() const override;
  std::shared_ptr<Shape> remake(std::shared_ptr<Material const> material) const override;

  Vec3 center_;
  double radius_;
};

/// Axis-parallel in its own frame. May be flat (min == max on an axis).
class Box final : public Shape {
 public:
  /// Two opposite corners in any order. Throws std::invalid_argument unless they are finite.
  Box(std::string name, Vec3 const& p1, Vec3 const& p2, std::shared_ptr<Material const> material);
  Vec3 const& min() const { return min_; }
  Vec3 const& max() const { return max_; }

  ShapeKind kind() const override { return ShapeKind::box; }
  Bounds bounds() const override { return {min_, max_}; }
  bool intersect(Ray const& ray, float& t) const override;
  bool closest_hit(Ray const& ray, double t_min, Hit& hit) const override;
  void accept(ShapeVisitor& visitor) const override;

 private:
  std::string description() const override;
  std::shared_ptr<Shape> remake(std::shared_ptr<Material const> material) const override;

  Vec3 min_;
  Vec3 max_;
};

/// Hit from both sides. A degenerate one (no area) is never hit.
class Triangle final : public Shape {
 public:
  /// Throws std::invalid_argument unless all corners are finite.
  Triangle(std::string name, Vec3 const& a, Vec3 const& b, Vec3 const& c, std::shared_ptr<Material const> material);
  std::array<Vec3, 3> const& vertices() const { return vertices_; }

  ShapeKind kind() const override { return ShapeKind::triangle; }
  Bounds bounds() const override;
  bool intersect(Ray const& ray, float& t) const override;
  bool closest_hit(Ray const& ray, double t_min, Hit& hit) const override;
  void accept(ShapeVisitor& visitor) const override;

 private:
  std::string description() const override;
  std::shared_ptr<Shape> remake(std::shared_ptr<Material const> material) const override;

  std::array<Vec3, 3> vertices_;
};

/// With a flat end at either point, at right angles to the way between them.
class Cylinder final : public Shape {
 public:
  /// `radius` > 0 and p1 != p2, all finite; else throws std::invalid_argument.
  Cylinder(std::string name, Vec3 const& p1, Vec3 const& p2, double radius, std::shared_ptr<Material const> material);
  Vec3 const& p1() const { return p1_; }
  Vec3 const& p2() const { return p2_; }
  double radius() const { return radius_; }

  ShapeKind kind() const override { return ShapeKind::cylinder; }
  Bounds bounds() const override;
  bool intersect(Ray const& ray, float& t) const override;
  bool closest_hit(Ray const& ray, double t_min, Hit& hit) const override;
  void accept(ShapeVisitor& visitor) const override;

 private:
  std::string description() const override;
  std::shared_ptr<Shape> remake(std::shared_ptr<Material const> material) const override;

  Vec3 p1_;
  Vec3 p2_;
  double radius_;
};

/// On a flat disc around the centre of its base, at right angles to the way to the tip.
class Cone final : public Shape {
 public:
  /// `radius` > 0 and base != tip, all finite; else throws std::invalid_argument.
  Cone(std::string name, Vec3 const& base, Vec3 const& tip, double radius, std::shared_ptr<Material const> material);
  Vec3 const& base() const { return base_; }
  Vec3 const& tip() const { return tip_; }
  double radius() const { return radius_; }

  ShapeKind kind() const override { return ShapeKind::cone; }
  Bounds bounds() const override;
  bool intersect(Ray const& ray, float& t) const override;
  bool closest_hit(Ray const& ray, double t_min, Hit& hit) const override;
  void accept(ShapeVisitor& visitor) const override;

 private:
  std::string description() const override;
  std::shared_ptr<Shape> remake(std::shared_ptr<Material const> material) const override;

  Vec3 base_;
  Vec3 tip_;
  double radius_;
};

/// Without an end, hit from both sides. No box holds it: what is framed or centred, the other shapes decide alone.
class Plane final : public Shape {
 public:
  /// `normal` has any length but zero, all finite; else throws std::invalid_argument.
  Plane(std::string name, Vec3 const& point, Vec3 const& normal, std::shared_ptr<Material const> material);
  Vec3 const& point() const { return point_; }
  Vec3 const& normal() const { return normal_; }

  ShapeKind kind() const override { return ShapeKind::plane; }
  Bounds bounds() const override { return {Vec3(-Bounds::infinity), Vec3(Bounds::infinity)}; }
  bool intersect(Ray const& ray, float& t) const override;
  bool closest_hit(Ray const& ray, double t_min, Hit& hit) const override;
  void accept(ShapeVisitor& visitor) const override;

 private:
  std::string description() const override;
  std::shared_ptr<Shape> remake(std::shared_ptr<Material const> material) const override;

  Vec3 point_;
  Vec3 normal_;
};

/// Triangles of one material, hit from both sides. Shows its geometry under its own transform; several meshes may share
/// one geometry, and one mesh may be the child of several composites.
class Mesh final : public Shape {
 public:
  /// Throws std::invalid_argument when `geometry` is null, an index is out of range, or an attribute list is neither
  /// empty nor as long as the positions.
  Mesh(std::string name, std::shared_ptr<MeshGeometry const> geometry, std::shared_ptr<Material const> material);
  std::shared_ptr<MeshGeometry const> const& geometry() const { return geometry_; }

  ShapeKind kind() const override { return ShapeKind::mesh; }
  /// Around those of its positions that are finite.
  Bounds bounds() const override { return bounds_; }
  bool intersect(Ray const& ray, float& t) const override;
  bool closest_hit(Ray const& ray, double t_min, Hit& hit) const override;
  void accept(ShapeVisitor& visitor) const override;

 private:
  std::string description() const override;
  std::shared_ptr<Shape> remake(std::shared_ptr<Material const> material) const override;

  std::shared_ptr<MeshGeometry const> geometry_;
  Bounds bounds_;
};

/// Spheres of one radius and one material around points, which may have colours of their own. Of its geometry, which
/// several may share, only positions and colours count; a position that is not finite is no point.
class PointCloud final : public Shape {
 public:
  /// Throws std::invalid_argument when `geometry` is null or has colours, but not as many as positions, or `radius` is
  /// not positive and finite.
  PointCloud(std::string name, std::shared_ptr<MeshGeometry const> geometry, double radius,
             std::shared_ptr<Material const> material);
  std::shared_ptr<MeshGeometry const> const& geometry() const { return geometry_; }
  double radius() const { return radius_; }
  void set_radius(double radius);

  ShapeKind kind() const override { return ShapeKind::point_cloud; }
  /// Around the spheres of those of its positions that are finite.
  Bounds bounds() const override;
  bool intersect(Ray const& ray, float& t) const override;
  bool closest_hit(Ray const& ray, double t_min, Hit& hit) const override;
  void accept(ShapeVisitor& visitor) const override;

 private:
  std::string description() const override;
  std::shared_ptr<Shape> remake(std::shared_ptr<Material const> material) const override;

  std::shared_ptr<MeshGeometry const> geometry_;
  Bounds centers_;
  double radius_ = 0;
};

/// Cylinders of one radius and one material along lines, with balls of that radius at their ends, so that lines which
/// meet are joined. Of its geometry, which several may share, only positions, lines and colours count; a line shades
/// from the colour of one end to that of the other. A line with an end that is not finite is none.
class LineSet final : public Shape {
 public:
  /// Throws std::invalid_argument when `geometry` is null, names an end that is out of range or has colours, but not as
  /// many as positions, or `radius` is not positive and finite.
  LineSet(std::string name, std::shared_ptr<MeshGeometry const> geometry, double radius,
          std::shared_ptr<Material const> material);
  std::shared_ptr<MeshGeometry const> const& geometry() const { return geometry_; }
  double radius() const { return radius_; }
  void set_radius(double radius);

  /// The numbers of the positions in which lines end, each once, in their order.
  std::vector<std::uint32_t> const& ends() const { return ends_; }
  std::size_t line_count() const { return geometry_->lines.size() / 2; }
  /// Whether both ends are finite.
  bool is_line(std::size_t number) const;

  ShapeKind kind() const override { return ShapeKind::line_set; }
  Bounds bounds() const override;
  bool intersect(Ray const& ray, float& t) const override;
  bool closest_hit(Ray const& ray, double t_min, Hit& hit) const override;
  void accept(ShapeVisitor& visitor) const override;

 private:
  std::string description() const override;
  std::shared_ptr<Shape> remake(std::shared_ptr<Material const> material) const override;

  std::shared_ptr<MeshGeometry const> geometry_;
  std::vector<std::uint32_t> ends_;
  Bounds axes_;
  double radius_ = 0;
};

/// A group of shapes under one transform.
class Composite final : public Shape {
 public:
  using Children = std::vector<std::shared_ptr<Shape>>;

  /// No child may be null: throws std::invalid_argument.
  explicit Composite(std::string name, Children children = {});
  ~Composite() override;

  /// The child must not hold this composite, directly or below: a cycle is refused with std::invalid_argument.
  void add(std::shared_ptr<Shape> child);
  Children const& children() const { return children_; }

  /// Whether the shapes below never move within this one: from one picture to the next it is transformed as a whole, or
  /// stays where it is. To be set by whoever makes it, for what may be large (thousands of triangles) and shown beside
  /// things that move; false at first. Only a hint, which moves no surface: a renderer may keep for such a composite
  /// what it built for the picture before, at the price of some time while it traces rays.
  bool moves_as_one() const { return moves_as_one_; }
  void set_moves_as_one(bool moves_as_one) { moves_as_one_ = moves_as_one; }

  ShapeKind kind() const override { return ShapeKind::composite; }
  Bounds bounds() const override { return {}; }
  bool intersect(Ray const& ray, float& t) const override;
  bool closest_hit(Ray const& ray, double t_min, Hit& hit) const override;
  void accept(ShapeVisitor& visitor) const override;

 private:
  std::string description() const override;
  std::shared_ptr<Shape> remake(std::shared_ptr<Material const> material) const override;

  bool holds(Composite const& sought) const;

  Children children_;
  bool has_parent_ = false;  // whether it ever became a child of a composite
  bool moves_as_one_ = false;
};

/// A function per kind of shape; forgetting one does not compile.
class ShapeVisitor {
 public:
  virtual void visit(Sphere const& sphere) = 0;
  virtual void visit(Box const& box) = 0;
  virtual void visit(Triangle const& triangle) = 0;
  virtual void visit(Cylinder const& cylinder) = 0;
  virtual void visit(Cone const& cone) = 0;
  virtual void visit(Plane const& plane) = 0;
  virtual void visit(Mesh const& mesh) = 0;
  virtual void visit(PointCloud const& points) = 0;
  virtual void visit(LineSet const& lines) = 0;
  virtual void visit(Composite const& composite) = 0;

 protected:
  ~ShapeVisitor() = default;
};

}  // namespace lichtraum
