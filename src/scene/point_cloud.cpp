#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "lichtraum/shapes.hpp"
#include "scene/sphere_passage.hpp"

namespace lichtraum {

PointCloud::PointCloud(std::string name, std::shared_ptr<MeshGeometry const> geometry, double radius,
                       std::shared_ptr<Material const> material)
    : Shape(std::move(name), std::move(material)), geometry_(std::move(geometry)) {
  if (!geometry_) throw std::invalid_argument("a point cloud needs a geometry");
  if (!geometry_->colors.empty() && geometry_->colors.size() != geometry_->positions.size()) {
    throw std::invalid_argument("a point cloud needs as many colours as positions");
  }
  centers_ = geometry_->bounds();
  set_radius(radius);
}

void PointCloud::set_radius(double radius) {
  if (!(radius > 0 && std::isfinite(radius))) throw std::invalid_argument("a point's radius must be positive");
  radius_ = radius;
}

Bounds PointCloud::bounds() const {
  return centers_.is_empty() ? centers_ : Bounds{centers_.min - radius_, centers_.max + radius_};
}

bool PointCloud::closest_hit(Ray const& ray, double t_min, Hit& hit) const {
  Ray const local = object_from_world(ray);
  bool is_hit = false;
  for (std::size_t i = 0; i < geometry_->positions.size(); ++i) {
    Float3 const& p = geometry_->positions[i];
    if (!take_hit(*this, sphere_passage(local, {p[0], p[1], p[2]}, radius_), t_min, hit)) continue;
    hit.triangle = i;
    is_hit = true;
  }
  return is_hit;
}

bool PointCloud::intersect(Ray const& ray, float& t) const { return intersect_closest(*this, ray, t); }

void PointCloud::accept(ShapeVisitor& visitor) const { visitor.visit(*this); }

std::string PointCloud::description() const {
  std::size_t const count = geometry_->positions.size();
  return fmt::format("{} {} of radius {}", count, count == 1 ? "point" : "points", radius_);
}

std::shared_ptr<Shape> PointCloud::remake(std::shared_ptr<Material const> material) const {
  return std::make_shared<PointCloud>(name(), geometry_, radius_, std::move(material));
}

}  // namespace lichtraum
