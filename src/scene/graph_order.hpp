#pragma once

#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

#include "lichtraum/shapes.hpp"

namespace lichtraum {

/// What flatten has to know of a composite before it unfolds anything. Counts saturate at `uncountable`.
struct GraphNode {
  static constexpr std::uint64_t uncountable = std::uint64_t(1) << 62;

  Composite const* composite = nullptr;
  std::uint64_t occurrences = 0;  ///< paths from a root to this node
  std::uint64_t primitives = 0;   ///< leaves below, one for each path
  std::uint32_t edges_in = 0;     ///< how often composites (or the list of roots) name it
  bool is_tree = true;            ///< no composite below is named twice
};

/// Every composite that can be reached from the roots.
struct GraphOrder {
  std::vector<GraphNode> nodes;  ///< children before parents
  std::unordered_map<Composite const*, std::uint32_t> index;

  GraphNode& operator[](Composite const* composite) { return nodes[index.at(composite)]; }
  GraphNode const& operator[](Composite const* composite) const { return nodes[index.at(composite)]; }
};

/// Linear in the number of nodes and edges, without recursion.
GraphOrder order_graph(std::vector<std::shared_ptr<Shape const>> const& roots);

/// `shape` when it is one, else null.
Composite const* as_composite(Shape const& shape);

/// The sum or product, at most `uncountable`.
inline std::uint64_t saturating_add(std::uint64_t a, std::uint64_t b) {
  return a + b < GraphNode::uncountable ? a + b : GraphNode::uncountable;
}
inline std::uint64_t saturating_multiply(std::uint64_t a, std::uint64_t b) {
  return a != 0 && b > GraphNode::uncountable / a ? GraphNode::uncountable : a * b;
}

}  // namespace lichtraum
