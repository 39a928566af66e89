#include "scene/copy_graph.hpp"

#include <unordered_map>

#include "scene/graph_order.hpp"

namespace lichtraum {
namespace {

/// Copies a node; a composite's children must have been copied before.
class NodeCopier final : private ShapeVisitor {
 public:
  std::shared_ptr<Shape> copy_of(Shape const& shape) {
    std::shared_ptr<Shape>& copy = copies_[&shape];
    if (copy) return copy;
    shape.accept(*this);
    if (!shape.world_from_object().is_identity()) made_->set_world_from_object(shape.world_from_object());
    // Looked up again: `copy` may have moved when a composite's children were.
    return copies_[&shape] = std::move(made_);
  }

 private:
  void visit(Sphere const& s) override {
    made_ = std::make_shared<Sphere>(s.name(), s.center(), s.radius(), s.material());
  }
  void visit(Box const& b) override { made_ = std::make_shared<Box>(b.name(), b.min(), b.max(), b.material()); }
  void visit(Triangle const& t) override {
    auto const& [a, b, c] = t.vertices();
    made_ = std::make_shared<Triangle>(t.name(), a, b, c, t.material());
  }
  void visit(Mesh const& m) override { made_ = std::make_shared<Mesh>(m.name(), m.geometry(), m.material()); }
  void visit(Composite const& composite) override {
    Composite::Children children;
    children.reserve(composite.children().size());
    for (auto const& child : composite.children()) children.push_back(copy_of(*child));
    made_ = std::make_shared<Composite>(composite.name(), std::move(children));
  }

  std::unordered_map<Shape const*, std::shared_ptr<Shape>> copies_;
  std::shared_ptr<Shape> made_;
};

}  // namespace

std::vector<std::shared_ptr<Shape const>> copy_graph(std::vector<std::shared_ptr<Shape const>> const& roots) {
  NodeCopier copier;
  for (GraphNode const& node : order_graph(roots).nodes) copier.copy_of(*node.shape);  // children before parents
  std::vector<std::shared_ptr<Shape const>> copies;
  for (auto const& root : roots) copies.push_back(copier.copy_of(*root));
  return copies;
}

}  // namespace lichtraum
