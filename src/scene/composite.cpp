#include <fmt/format.h>

#include <glm/matrix.hpp>
#include <iterator>
#include <stdexcept>
#include <unordered_set>

#include "lichtraum/shapes.hpp"
#include "scene/graph_order.hpp"
#include "scene/leaf_hit.hpp"

// Nothing here recurses: how deep a graph is nested, a scene file decides.

namespace lichtraum {

Composite::Composite(std::string name, Children children)
    : Shape(std::move(name), nullptr), children_(std::move(children)) {
  for (auto const& child : children_) {
    if (!child) throw std::invalid_argument("a composite's child must not be null");
  }
  for (auto const& child : children_) {
    if (auto* const composite = dynamic_cast<Composite*>(child.get())) composite->has_parent_ = true;
  }
}

Composite::~Composite() {
  Children orphans = std::move(children_);
  while (!orphans.empty()) {
    std::shared_ptr<Shape> const orphan = std::move(orphans.back());
    orphans.pop_back();
    if (orphan.use_count() != 1) continue;
    if (auto* const composite = dynamic_cast<Composite*>(orphan.get())) {
      std::move(composite->children_.begin(), composite->children_.end(), std::back_inserter(orphans));
      composite->children_.clear();
    }
  }
}

void Composite::add(std::shared_ptr<Shape> child) {
  if (!child) throw std::invalid_argument("a composite's child must not be null");
  if (auto* const composite = dynamic_cast<Composite*>(child.get())) {
    // Who is nobody's child cannot be below its own: building a graph from its leaves upwards costs no search.
    if (composite == this || (has_parent_ && composite->holds(*this))) {
      throw std::invalid_argument("composite '" + name() + "' would contain itself");
    }
    composite->has_parent_ = true;
  }
  children_.push_back(std::move(child));
}

bool Composite::holds(Composite const& sought) const {
  std::unordered_set<Composite const*> seen{this};
  std::vector<Composite const*> pending{this};
  while (!pending.empty()) {
    Composite const* const parent = pending.back();
    pending.pop_back();
    for (auto const& child : parent->children_) {
      Composite const* const composite = as_composite(*child);
      if (!composite) continue;
      if (composite == &sought) return true;
      if (seen.insert(composite).second) pending.push_back(composite);
    }
  }
  return false;
}

bool Composite::closest_hit(Ray const& ray, double t_min, Hit& hit) const {
  struct Level {
    Composite const* composite;
    std::size_t next_child;
    Ray ray;         // in the composite's own frame
    Mat3 normal_up;  // from that frame's normals to those of the frame that was asked in
    Mat3 vector_up;  // the same of directions
  };
  auto const enter = [](Composite const& composite, Ray const& outer_ray, Mat3 const& outer_normal_up,
                        Mat3 const& outer_vector_up) {
    Transform const& to_parent = composite.world_from_object();
    return Level{&composite, 0, composite.object_from_world(outer_ray),
                 outer_normal_up * glm::transpose(Mat3(to_parent.inverse_matrix())),
                 outer_vector_up * Mat3(to_parent.matrix())};
  };

  bool found = false;
  std::vector<Level> levels;
  levels.push_back(enter(*this, ray, Mat3(1), Mat3(1)));
  while (!levels.empty()) {
    Level& level = levels.back();
    if (level.next_child == level.composite->children_.size()) {
      levels.pop_back();
      continue;
    }
    Shape const& child = *level.composite->children_[level.next_child++];
    if (Composite const* const composite = as_composite(child)) {
      Level inner = enter(*composite, level.ray, level.normal_up, level.vector_up);
      bool const was_last = level.next_child == level.composite->children_.size();
      if (was_last) {
        level = inner;
      } else {
        levels.push_back(inner);
      }
    } else if (child.closest_hit(level.ray, t_min, hit)) {
      hit.normal = unit_vector(level.normal_up * hit.normal);
      hit.linear_from_shape = level.vector_up * hit.linear_from_shape;
      found = true;
    }
  }
  return found;
}

bool Composite::intersect(Ray const& ray, float& t) const { return intersect_closest(*this, ray, t); }

void Composite::accept(ShapeVisitor& visitor) const { visitor.visit(*this); }

std::string Composite::description() const {
  std::size_t const count = children_.size();
  return fmt::format("{} {}", count, count == 1 ? "child" : "children");
}

std::shared_ptr<Shape> Composite::remake(std::shared_ptr<Material const>) const {
  auto copy = std::make_shared<Composite>(name(), children_);
  copy->set_moves_as_one(moves_as_one_);
  return copy;
}

}  // namespace lichtraum
