#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/float3.hpp"
#include "lichtraum/shapes.hpp"
#include "scene/cylinder_passage.hpp"
#include "scene/sphere_passage.hpp"

namespace lichtraum {
LineSet::LineSet(std::string name, std::shared_ptr<MeshGeometry const> geometry, double radius,
                 std::shared_ptr<Material const> material)
    : Shape(std::move(name), std::move(material)), geometry_(std::move(geometry)) {
  if (!geometry_) throw std::invalid_argument("a line set needs a geometry");
  std::size_t const count = geometry_->positions.size();
  if (!geometry_->colors.empty() && geometry_->colors.size() != count) {
    throw std::invalid_argument("a line set needs as many colours as positions");
  }
  std::vector<std::uint32_t> const& lines = geometry_->lines;
  if (lines.size() % 2 != 0) throw std::invalid_argument("a line needs two ends");
  if (std::any_of(lines.begin(), lines.end(), [&](std::uint32_t end) { return end >= count; })) {
    throw std::invalid_argument("a line ends in a position that is not there");
  }
  std::vector<bool> is_end(count, false);
  for (std::size_t i = 0; i < line_count(); ++i) {
    if (is_line(i)) is_end[lines[2 * i]] = is_end[lines[2 * i + 1]] = true;
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (!is_end[i]) continue;
    ends_.push_back(std::uint32_t(i));
    axes_.add(to_vec3(geometry_->positions[i]));
  }
  set_radius(radius);
}

void LineSet::set_radius(double radius) {
  if (!(radius > 0 && std::isfinite(radius))) throw std::invalid_argument("a line's radius must be positive");
  radius_ = radius;
}

bool LineSet::is_line(std::size_t number) const {
  std::uint32_t const* const ends = geometry_->lines.data() + 2 * number;
  return is_finite(geometry_->positions[ends[0]]) && is_finite(geometry_->positions[ends[1]]);
}

Bounds LineSet::bounds() const { return axes_.is_empty() ? axes_ : Bounds{axes_.min - radius_, axes_.max + radius_}; }

bool LineSet::closest_hit(Ray const& ray, double t_min, Hit& hit) const {
  Ray const local = object_from_world(ray);
  bool is_hit = false;
  for (std::size_t i = 0; i < line_count(); ++i) {
    if (!is_line(i)) continue;
    Vec3 const p1 = to_vec3(geometry_->positions[geometry_->lines[2 * i]]);
    Vec3 const p2 = to_vec3(geometry_->positions[geometry_->lines[2 * i + 1]]);
    auto const take = [&](Passage const& passage, double near_p2) {
      if (!take_hit(*this, passage, t_min, hit)) return false;
      hit.triangle = i;
      hit.barycentric = Vec3(1 - near_p2, near_p2, 0);
      return is_hit = true;
    };
    take(sphere_passage(local, p1, radius_), 0);
    take(sphere_passage(local, p2, radius_), 1);
    Vec3 const axis = p2 - p1;
    if (axis != Vec3(0) && take(cylinder_passage(local, p1, p2, radius_), 0)) {
      double const near_p2 = std::clamp(glm::dot(local.at(hit.t) - p1, axis) / glm::dot(axis, axis), 0.0, 1.0);
      hit.barycentric = Vec3(1 - near_p2, near_p2, 0);
    }
  }
  return is_hit;
}

bool LineSet::intersect(Ray const& ray, float& t) const { return intersect_closest(*this, ray, t); }

void LineSet::accept(ShapeVisitor& visitor) const { visitor.visit(*this); }

std::string LineSet::description() const {
  return fmt::format("{} {} of radius {}", line_count(), line_count() == 1 ? "line" : "lines", radius_);
}

std::shared_ptr<Shape> LineSet::remake(std::shared_ptr<Material const> material) const {
  return std::make_shared<LineSet>(name(), geometry_, radius_, std::move(material));
}

}  // namespace lichtraum
