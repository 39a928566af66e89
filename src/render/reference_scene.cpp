#include "render/reference_scene.hpp"

#include <glm/common.hpp>
#include <limits>
#include <unordered_map>
#include <unordered_set>

#include "render/drawn_roots.hpp"
#include "scene/graph_order.hpp"

namespace lichtraum {
namespace {

struct Bounds {
  Vec3 min{std::numeric_limits<double>::infinity()};
  Vec3 max{-std::numeric_limits<double>::infinity()};

  bool is_empty() const { return !(min.x <= max.x); }
  void include(Vec3 const& p) {
    min = glm::min(min, p);
    max = glm::max(max, p);
  }
  void include(Bounds const& other) {
    min = glm::min(min, other.min);
    max = glm::max(max, other.max);
  }
};

/// The box around a box under an affine map: its centre is mapped, its half size by the matrix' absolute values.
Bounds transformed(Transform const& t, Bounds const& box) {
  if (box.is_empty()) return box;
  Vec3 const center = t.point((box.min + box.max) / 2.0);
  Vec3 const half = (box.max - box.min) / 2.0;
  Mat4 const& m = t.matrix();
  Vec3 const reach = glm::abs(Vec3(m[0])) * half.x + glm::abs(Vec3(m[1])) * half.y + glm::abs(Vec3(m[2])) * half.z;
  return {center - reach, center + reach};
}

/// The bounds of shapes that are no composite, in the frame of their parent, and how many were seen.
class LeafVisitor final : private ShapeVisitor {
 public:
  Bounds bounds_of(Shape const& leaf) {
    bounds_ = {};
    is_new_ = seen_.insert(&leaf).second;
    leaf.accept(*this);
    return bounds_;
  }
  SceneStatistics const& statistics() const { return statistics_; }

 private:
  void visit(Sphere const& sphere) override {
    statistics_.spheres += is_new_;
    // An ellipsoid reaches as far along an axis as that row of its matrix is long.
    Transform const& t = sphere.world_from_object();
    Mat3 const rows = glm::transpose(Mat3(t.matrix()));
    Vec3 const reach = sphere.radius() * Vec3(glm::length(rows[0]), glm::length(rows[1]), glm::length(rows[2]));
    Vec3 const center = t.point(sphere.center());
    bounds_ = {center - reach, center + reach};
  }

  void visit(Box const& box) override {
    statistics_.boxes += is_new_;
    bounds_ = transformed(box.world_from_object(), {box.min(), box.max()});
  }

  void visit(Triangle const& triangle) override {
    statistics_.triangles += is_new_;
    for (Vec3 const& vertex : triangle.vertices()) bounds_.include(triangle.world_from_object().point(vertex));
  }

  void visit(Mesh const& mesh) override {
    statistics_.triangles += is_new_ ? mesh.geometry()->triangle_count() : 0;
    for (auto const& p : mesh.geometry()->positions) {
      bounds_.include(mesh.world_from_object().point(Vec3(p[0], p[1], p[2])));
    }
  }

  void visit(Composite const&) override {}  // no leaf

  std::unordered_set<Shape const*> seen_;
  SceneStatistics statistics_;
  Bounds bounds_;
  bool is_new_ = false;
};

}  // namespace

std::vector<Light> casting_shadows(std::vector<Light> const& lights) {
  std::vector<Light> result;
  for (Light const& light : lights) {
    if (light.kind() != LightKind::ambient) result.push_back(light);
  }
  return result;
}

ReferenceScene make_reference_scene(Scene const& scene, std::string_view root) {
  ReferenceScene result{shading_of(scene), {}, {}};
  result.roots = drawn_roots(scene, root);
  result.lights = casting_shadows({scene.lights.begin(), scene.lights.end()});
  return result;
}

GraphSummary summarise(std::vector<std::shared_ptr<Shape const>> const& roots) {
  GraphOrder const order = order_graph(roots);
  LeafVisitor leaves;
  std::unordered_map<Shape const*, Bounds> bounds_of_composites;
  auto const bounds_of = [&](Shape const& shape) {
    return as_composite(shape) ? bounds_of_composites.at(&shape) : leaves.bounds_of(shape);
  };
  GraphSummary result;
  std::uint64_t instances = 0;
  for (GraphNode const& node : order.nodes) {  // children first
    if (node.edges_in > 1) instances += node.edges_in;
    if (!node.composite) continue;
    Bounds bounds;
    for (auto const& child : node.composite->children()) bounds.include(bounds_of(*child));
    bounds_of_composites[node.shape] = transformed(node.shape->world_from_object(), bounds);
  }
  Bounds bounds;
  for (auto const& root : roots) {
    bounds.include(bounds_of(*root));
    std::uint64_t const primitives = is_graph_node(*root) ? order[root.get()].primitives : 1;
    result.drawn_primitives = saturating_add(result.drawn_primitives, primitives);
  }
  result.statistics = leaves.statistics();
  result.statistics.instances = instances;
  result.bounds_min = bounds.min;
  result.bounds_max = bounds.max;
  return result;
}

}  // namespace lichtraum
