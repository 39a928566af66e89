#include "lichtraum/graph_summary.hpp"

#include <unordered_set>

#include "lichtraum/shapes.hpp"
#include "scene/graph_fold.hpp"

namespace lichtraum {
namespace {

static_assert(ShapeCounts::uncountable == GraphNode::uncountable);

void add(ShapeCounts& counts, ShapeCounts const& more) {
  for (std::size_t i = 0; i < shape_kind_count; ++i) {
    counts.of_kind[i] = saturating_add(counts.of_kind[i], more.of_kind[i]);
  }
  counts.mesh_triangles = saturating_add(counts.mesh_triangles, more.mesh_triangles);
  counts.points = saturating_add(counts.points, more.points);
  counts.lines = saturating_add(counts.lines, more.lines);
  counts.line_ends = saturating_add(counts.line_ends, more.line_ends);
}

/// The shape itself, without what is below it.
ShapeCounts one(Shape const& shape) {
  ShapeCounts counts;
  counts.of_kind[std::size_t(shape.kind())] = 1;
  if (Mesh const* const mesh = as_mesh(shape)) counts.mesh_triangles = mesh->geometry()->triangle_count();
  if (PointCloud const* const cloud = as_point_cloud(shape)) counts.points = cloud->geometry()->positions.size();
  if (LineSet const* const lines = as_line_set(shape)) {
    counts.lines = lines->line_count();
    counts.line_ends = lines->ends().size();
  }
  return counts;
}

/// Calls `visit` for each shape that can be reached, once.
template <class Visit>
void for_each_shape(std::vector<std::shared_ptr<Shape const>> const& roots, Visit const& visit) {
  std::unordered_set<Shape const*> seen;
  auto const visit_new = [&](auto const& shapes) {
    for (auto const& shape : shapes) {
      if (seen.insert(shape.get()).second) visit(*shape);
    }
  };
  visit_new(roots);
  for (GraphNode const& node : order_graph(roots).nodes) {
    if (node.composite) visit_new(node.composite->children());
  }
}

ShapeCounts count_each_once(std::vector<std::shared_ptr<Shape const>> const& roots) {
  ShapeCounts counts;
  for_each_shape(roots, [&](Shape const& shape) { add(counts, one(shape)); });
  return counts;
}

}  // namespace

std::uint64_t ShapeCounts::primitives() const {
  std::uint64_t sum = saturating_add(saturating_add(mesh_triangles, points), saturating_add(lines, line_ends));
  for (std::size_t i = 0; i < shape_kind_count; ++i) {
    auto const kind = ShapeKind(i);
    bool const holds_others = kind == ShapeKind::mesh || kind == ShapeKind::point_cloud ||
                              kind == ShapeKind::line_set || kind == ShapeKind::composite;
    if (!holds_others) sum = saturating_add(sum, of_kind[i]);
  }
  return sum;
}

GraphSummary summarise(std::vector<std::shared_ptr<Shape const>> const& roots) {
  GraphSummary summary;
  summary.defined = count_each_once(roots);
  summary.drawn =
      fold_graph<ShapeCounts>(roots, one, [](ShapeCounts& counts, Shape const& child, ShapeCounts const& below) {
        if (as_composite(child)) add(counts, one(child));
        add(counts, below);
      }).total();
  summary.bounds = fold_bounds(roots).total();
  return summary;
}

std::vector<std::shared_ptr<Material const>> materials_of(std::vector<std::shared_ptr<Shape const>> const& roots) {
  std::vector<std::shared_ptr<Material const>> materials;
  std::unordered_set<Material const*> seen;
  for_each_shape(roots, [&](Shape const& shape) {
    auto const& material = shape.material();
    if (material && seen.insert(material.get()).second) materials.push_back(material);
  });
  return materials;
}

}  // namespace lichtraum
