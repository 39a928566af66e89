#include "scene/copy_graph.hpp"

#include <unordered_map>

#include "scene/graph_order.hpp"

namespace lichtraum {
namespace {

/// Copies a node. A composite's children are to be copied first, or this recurses as deep as the graph.
class NodeCopier final : private ShapeVisitor {
 public:
  explicit NodeCopier(MaterialChoice const& material_of) : material_of_(material_of) {}

  std::shared_ptr<Shape> copy_of(Shape const& shape) {
    std::shared_ptr<Shape>& copy = copies_[&shape];
    if (copy) return copy;
    shape.accept(*this);
    if (!shape.world_from_object().is_identity()) made_->set_world_from_object(shape.world_from_object());
    copy = std::move(made_);
    return copy;
  }

 private:
  void visit(Sphere const& s) override {
    made_ = std::make_shared<Sphere>(s.name(), s.center(), s.radius(), material_of_(s));
  }
  void visit(Box const& b) override { made_ = std::make_shared<Box>(b.name(), b.min(), b.max(), material_of_(b)); }
  void visit(Triangle const& t) override {
    auto const& [a, b, c] = t.vertices();
    made_ = std::make_shared<Triangle>(t.name(), a, b, c, material_of_(t));
  }
  void visit(Mesh const& m) override { made_ = std::make_shared<Mesh>(m.name(), m.geometry(), material_of_(m)); }
  void visit(Composite const& composite) override {
    Composite::Children children;
    children.reserve(composite.children().size());
    for (auto const& child : composite.children()) children.push_back(copy_of(*child));
    auto copy = std::make_shared<Composite>(composite.name(), std::move(children));
    copy->set_moves_as_one(composite.moves_as_one());
    made_ = std::move(copy);
  }

  MaterialChoice const& material_of_;
  std::unordered_map<Shape const*, std::shared_ptr<Shape>> copies_;
  std::shared_ptr<Shape> made_;
};

}  // namespace

std::vector<std::shared_ptr<Shape>> copy_graph(std::vector<std::shared_ptr<Shape const>> const& roots,
                                               MaterialChoice const& material_of) {
  NodeCopier copier(material_of);
  for (GraphNode const& node : order_graph(roots).nodes) copier.copy_of(*node.shape);  // children before parents
  std::vector<std::shared_ptr<Shape>> copies;
  for (auto const& root : roots) copies.push_back(copier.copy_of(*root));
  return copies;
}

std::vector<std::shared_ptr<Shape>> copy_graph(
    std::vector<std::shared_ptr<Shape const>> const& roots,
    std::unordered_map<Material const*, Material> const& replaced_materials) {
  std::unordered_map<Material const*, std::shared_ptr<Material const>> replaced;
  for (auto const& [old, material] : replaced_materials) replaced.emplace(old, std::make_shared<Material>(material));
  return copy_graph(roots, [&](Shape const& shape) {
    auto const found = replaced.find(shape.material().get());
    return found == replaced.end() ? shape.material() : found->second;
  });
}

}  // namespace lichtraum
