#pragma once

#include <memory>
#include <unordered_map>
#include <vector>

#include "scene/graph_order.hpp"

namespace lichtraum {

/// A value for each shape that can be reached, made of the values of the shapes below it: children first, without
/// recursion, each composite once however many paths lead there.
///
///   leaf(shape)                       the value of a shape that is not a composite
///   add(value, child, child's value)  takes a child into its composite's value, which begins as Value()
template <class Value, class Leaf, class Add>
class GraphFold {
 public:
  GraphFold(std::vector<std::shared_ptr<Shape const>> const& roots, Leaf leaf, Add add)
      : leaf_(std::move(leaf)), add_(std::move(add)) {
    for (GraphNode const& node : order_graph(roots).nodes) {
      if (node.composite) composites_.emplace(node.shape, sum_of(node.composite->children()));
    }
    total_ = sum_of(roots);
  }

  Value of(Shape const& shape) const { return as_composite(shape) ? composites_.at(&shape) : leaf_(shape); }
  /// Of all roots, as if they were the children of one composite.
  Value const& total() const { return total_; }
  std::unordered_map<Shape const*, Value> const& composites() const { return composites_; }

 private:
  template <class Shapes>
  Value sum_of(Shapes const& shapes) const {
    Value sum{};
    for (auto const& shape : shapes) add_(sum, *shape, of(*shape));
    return sum;
  }

  Leaf leaf_;
  Add add_;
  std::unordered_map<Shape const*, Value> composites_;
  Value total_;
};

template <class Value, class Leaf, class Add>
GraphFold<Value, Leaf, Add> fold_graph(std::vector<std::shared_ptr<Shape const>> const& roots, Leaf leaf, Add add) {
  return {roots, std::move(leaf), std::move(add)};
}

/// The boxes around shapes with all below them that has an end, each in its own frame; the total is in the world. A
/// composite's is the box around its children's boxes: where those are turned it may be larger than its contents.
inline auto fold_bounds(std::vector<std::shared_ptr<Shape const>> const& roots) {
  return fold_graph<Bounds>(
      roots, [](Shape const& shape) { return shape.bounds().is_finite() ? shape.bounds() : Bounds(); },
      [](Bounds& bounds, Shape const& child, Bounds const& own) {
        bounds.add(mapped(child.world_from_object(), own));
      });
}

}  // namespace lichtraum
