#include "scene/graph_order.hpp"

namespace lichtraum {
namespace {

/// Appends `root` and all nodes below it that are not in the order yet: a depth-first walk with its own stack.
void append_in_postorder(Shape const& root, GraphOrder& order) {
  struct Visit {
    Shape const* shape;
    Composite const* composite;
    std::size_t next_child = 0;
  };
  std::vector<Visit> open;
  auto const enter = [&](Shape const& shape) {
    // Claimed at once, so that a second edge to it does not enter it again; its place is known when it is left.
    if (order.index.emplace(&shape, 0).second) open.push_back({&shape, as_composite(shape)});
  };
  enter(root);
  while (!open.empty()) {
    Visit& visit = open.back();
    if (visit.composite && visit.next_child < visit.composite->children().size()) {
      Shape const& child = *visit.composite->children()[visit.next_child++];
      if (is_graph_node(child)) enter(child);
      continue;
    }
    order.index[visit.shape] = std::uint32_t(order.nodes.size());
    order.nodes.push_back({visit.shape, visit.composite});
    open.pop_back();
  }
}

void count_edge(GraphNode& node, std::uint64_t paths) {
  node.occurrences = saturating_add(node.occurrences, paths);
  ++node.edges_in;
}

std::uint64_t leaf_primitives(Shape const& shape) {
  if (PointCloud const* const points = as_point_cloud(shape)) return points->geometry()->positions.size();
  if (LineSet const* const lines = as_line_set(shape)) return lines->line_count() + lines->ends().size();
  return as_mesh(shape)->geometry()->triangle_count();
}

void count_below(GraphNode& node, GraphOrder const& order) {
  if (!node.composite) {
    node.primitives = leaf_primitives(*node.shape);
    return;
  }
  for (auto const& child : node.composite->children()) {
    if (!is_graph_node(*child)) {
      node.primitives = saturating_add(node.primitives, 1);
      continue;
    }
    GraphNode const& below = order[child.get()];
    node.primitives = saturating_add(node.primitives, below.primitives);
    node.is_tree = node.is_tree && below.is_tree && below.edges_in == 1;
  }
}

}  // namespace

Composite const* as_composite(Shape const& shape) {
  return shape.kind() == ShapeKind::composite ? static_cast<Composite const*>(&shape) : nullptr;
}
Mesh const* as_mesh(Shape const& shape) {
  return shape.kind() == ShapeKind::mesh ? static_cast<Mesh const*>(&shape) : nullptr;
}

PointCloud const* as_point_cloud(Shape const& shape) {
  return shape.kind() == ShapeKind::point_cloud ? static_cast<PointCloud const*>(&shape) : nullptr;
}

LineSet const* as_line_set(Shape const& shape) {
  return shape.kind() == ShapeKind::line_set ? static_cast<LineSet const*>(&shape) : nullptr;
}

GraphOrder order_graph(std::vector<std::shared_ptr<Shape const>> const& roots) {
  GraphOrder order;
  for (auto const& root : roots) {
    if (is_graph_node(*root)) append_in_postorder(*root, order);
  }
  for (auto const& root : roots) {
    if (is_graph_node(*root)) count_edge(order[root.get()], 1);
  }
  for (auto parent = order.nodes.rbegin(); parent != order.nodes.rend(); ++parent) {  // parents first
    if (!parent->composite) continue;
    for (auto const& child : parent->composite->children()) {
      if (is_graph_node(*child)) count_edge(order[child.get()], parent->occurrences);
    }
  }
  for (GraphNode& node : order.nodes) count_below(node, order);  // children first
  return order;
}

}  // namespace lichtraum
