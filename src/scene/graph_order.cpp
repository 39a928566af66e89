#include "scene/graph_order.hpp"

namespace lichtraum {
namespace {

/// Appends `root` and all composites below it that are not in the order yet: a depth-first walk with its own stack.
void append_in_postorder(Composite const& root, GraphOrder& order) {
  struct Visit {
    Composite const* composite;
    std::size_t next_child = 0;
  };
  std::vector<Visit> open;
  auto const enter = [&](Composite const& composite) {
    // Claimed at once, so that a second edge to it does not enter it again; its place is known when it is left.
    if (order.index.emplace(&composite, 0).second) open.push_back({&composite});
  };
  enter(root);
  while (!open.empty()) {
    Visit& visit = open.back();
    if (visit.next_child < visit.composite->children().size()) {
      Shape const& child = *visit.composite->children()[visit.next_child++];
      if (auto const* below = as_composite(child)) enter(*below);
      continue;
    }
    order.index[visit.composite] = std::uint32_t(order.nodes.size());
    order.nodes.push_back({visit.composite});
    open.pop_back();
  }
}

void count_edge(GraphNode& node, std::uint64_t paths) {
  node.occurrences = saturating_add(node.occurrences, paths);
  ++node.edges_in;
}

}  // namespace

Composite const* as_composite(Shape const& shape) { return dynamic_cast<Composite const*>(&shape); }

GraphOrder order_graph(std::vector<std::shared_ptr<Shape const>> const& roots) {
  GraphOrder order;
  for (auto const& root : roots) {
    if (auto const* composite = as_composite(*root)) append_in_postorder(*composite, order);
  }
  for (auto const& root : roots) {
    if (auto const* composite = as_composite(*root)) count_edge(order[composite], 1);
  }
  for (auto parent = order.nodes.rbegin(); parent != order.nodes.rend(); ++parent) {  // parents first
    for (auto const& child : parent->composite->children()) {
      if (auto const* below = as_composite(*child)) count_edge(order[below], parent->occurrences);
    }
  }
  for (GraphNode& node : order.nodes) {  // children first
    for (auto const& child : node.composite->children()) {
      auto const* composite = as_composite(*child);
      if (!composite) {
        node.primitives = saturating_add(node.primitives, 1);
        continue;
      }
      GraphNode const& below = order[composite];
      node.primitives = saturating_add(node.primitives, below.primitives);
      node.is_tree = node.is_tree && below.is_tree && below.edges_in == 1;
    }
  }
  return order;
}

}  // namespace lichtraum
