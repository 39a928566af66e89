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

  Shape const* shape = nullptr;
  Composite const* composite = nullptr;  ///< null for a mesh, points or lines
  std::uint64_t occurrences = 0;         ///< paths from a root to this node
  std::uint64_t primitives = 0;          ///< leaves, triangles of meshes, points and what lines are made of
  std::uint32_t edges_in = 0;            ///< how often composites (or the list of roots) name it
  bool is_tree = true;                   ///< no node below is named twice
};

/// Every composite, mesh, point cloud and line set that can be reached from the roots: all that may hold more than one
/// primitive.
struct GraphOrder {
  std::vector<GraphNode> nodes;  ///< children before parents
  std::unordered_map<Shape const*, std::uint32_t> index;

  GraphNode& operator[](Shape const* shape) { return nodes[index.at(shape)]; }
  GraphNode const& operator[](Shape const* shape) const { return nodes[index.at(shape)]; }
};

/// Linear in the number of nodes and edges, without recursion.
GraphOrder order_graph(std::vector<std::shared_ptr<Shape const>> const& roots);

/// `shape` when it is one, else null.
Composite const* as_composite(Shape const& shape);
Mesh const* as_mesh(Shape const& shape);
PointCloud const* as_point_cloud(Shape const& shape);
LineSet const* as_line_set(Shape const& shape);
/// Whether `shape` has a node in the order.
inline bool is_graph_node(Shape const& shape) {
  return as_composite(shape) || as_mesh(shape) || as_point_cloud(shape) || as_line_set(shape);
}

/// The sum or product, at most `uncountable`.
inline std::uint64_t saturating_add(std::uint64_t a, std::uint64_t b) {
  return a + b < GraphNode::uncountable ? a + b : GraphNode::uncountable;
}
inline std::uint64_t saturating_multiply(std::uint64_t a, std::uint64_t b) {
  return a != 0 && b > GraphNode::uncountable / a ? GraphNode::uncountable : a * b;
}

}  // namespace lichtraum
