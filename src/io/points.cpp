#include "io/points.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "scene/graph_fold.hpp"

namespace lichtraum {
namespace {

constexpr double unset_radius = 1e-30;

/// Of lengths: the root mean square over the axes.
double length_scale(Transform const& transform) {
  Mat3 const m(transform.matrix());
  return std::sqrt((glm::dot(m[0], m[0]) + glm::dot(m[1], m[1]) + glm::dot(m[2], m[2])) / 3);
}

/// Of every node of the graph, from its own frame to the world's.
std::vector<double> length_scales(GraphOrder const& order, std::vector<std::shared_ptr<Shape const>> const& roots) {
  std::vector<double> scales(order.nodes.size(), 0);  // 0: nothing leads there yet
  auto const arrive = [&](Shape const& shape, double parent_scale) {
    if (!is_graph_node(shape)) return;
    double& scale = scales[order.index.at(&shape)];
    if (scale == 0) scale = parent_scale * length_scale(shape.world_from_object());
  };
  for (auto const& root : roots) arrive(*root, 1);
  for (std::size_t i = order.nodes.size(); i-- > 0;) {  // parents first
    if (!order.nodes[i].composite) continue;
    for (auto const& child : order.nodes[i].composite->children()) arrive(*child, scales[i]);
  }
  return scales;
}

}  // namespace

std::size_t reduce_to_points(MeshGeometry& geometry) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < geometry.positions.size(); ++i) {
    Float3 const& p = geometry.positions[i];
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2])) continue;
    geometry.positions[kept] = p;
    if (!geometry.colors.empty()) geometry.colors[kept] = geometry.colors[i];
    ++kept;
  }
  std::size_t const left_out = geometry.positions.size() - kept;
  geometry.positions.resize(kept);
  if (!geometry.colors.empty()) geometry.colors.resize(kept);
  geometry.normals = {};
  geometry.tangents = {};
  geometry.texcoords = {};
  return left_out;
}

std::shared_ptr<Shape> make_shape(std::string name, std::shared_ptr<MeshGeometry const> geometry,
                                  std::shared_ptr<Material const> material) {
  if (!geometry->indices.empty()) {
    return std::make_shared<Mesh>(std::move(name), std::move(geometry), std::move(material));
  }
  if (!geometry->lines.empty()) {
    return std::make_shared<LineSet>(std::move(name), std::move(geometry), unset_radius, std::move(material));
  }
  return std::make_shared<PointCloud>(std::move(name), std::move(geometry), unset_radius, std::move(material));
}

bool has_points_or_lines(Scene const& scene) {
  return std::ranges::any_of(scene.shapes,
                             [](auto const& shape) { return as_point_cloud(*shape) || as_line_set(*shape); });
}

void set_point_sizes(Scene& scene, std::optional<double> size) {
  std::vector<std::shared_ptr<PointCloud>> clouds;
  std::vector<std::shared_ptr<LineSet>> line_sets;
  std::size_t points = 0, line_ends = 0;
  for (auto const& shape : scene.shapes) {
    if (auto cloud = std::dynamic_pointer_cast<PointCloud>(shape)) {
      points += cloud->geometry()->positions.size();
      clouds.push_back(std::move(cloud));
    } else if (auto lines = std::dynamic_pointer_cast<LineSet>(shape)) {
      line_ends += lines->ends().size();
      line_sets.push_back(std::move(lines));
    }
  }
  if (clouds.empty() && line_sets.empty()) return;

  auto const roots = scene.roots();
  GraphOrder const order = order_graph(roots);
  std::vector<double> const scales = length_scales(order, roots);
  Bounds const box = fold_bounds(roots).total();
  double const diagonal = glm::length(box.max - box.min);
  auto const set_diameter = [&](auto const& shapes, double thousandths) {
    // A point alone is a ball of a thousandth.
    double const diameter = thousandths / 1000 * (diagonal > 1e3 * unset_radius ? diagonal : 1.0);
    for (auto const& shape : shapes) {
      auto const node = order.index.find(shape.get());
      double const scale = node == order.index.end() ? 1 : scales[node->second];
      double const radius = 0.5 * diameter / scale;
      if (radius > 0 && std::isfinite(radius)) shape->set_radius(radius);
    }
  };
  set_diameter(clouds, size.value_or(std::clamp(1200 / std::sqrt(double(points)), 0.25, 10.0)));
  set_diameter(line_sets, size.value_or(std::clamp(250 / std::sqrt(double(line_ends)), 0.25, 4.0)));
}

}  // namespace lichtraum
