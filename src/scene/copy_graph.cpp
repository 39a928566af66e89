#include "scene/copy_graph.hpp"

#include <unordered_map>

#include "scene/graph_order.hpp"

namespace lichtraum {
namespace {

/// Copies nodes, children before parents.
class NodeCopier {
 public:
  explicit NodeCopier(MaterialChoice const& material_of) : material_of_(material_of) {}

  std::shared_ptr<Shape> copy_of(Shape const& shape) {
    std::shared_ptr<Shape>& copy = copies_[&shape];
    if (!copy) copy = make_copy(shape);
    return copy;
  }

 private:
  std::shared_ptr<Shape> make_copy(Shape const& shape) {
    Composite const* const composite = as_composite(shape);
    if (!composite) return shape.copy(material_of_(shape));
    Composite::Children children;
    children.reserve(composite->children().size());
    for (auto const& child : composite->children()) children.push_back(copy_of(*child));
    auto copy = std::make_shared<Composite>(composite->name(), std::move(children));
    copy->set_moves_as_one(composite->moves_as_one());
    copy->set_world_from_object(composite->world_from_object());
    return copy;
  }

  MaterialChoice const& material_of_;
  std::unordered_map<Shape const*, std::shared_ptr<Shape>> copies_;
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
