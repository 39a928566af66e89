#include "mesh_file.hpp"

#include "lichtraum/gltf.hpp"

namespace lichtraum::bench {
namespace {

/// Puts every mesh below a shape into one, in the world.
class Collector final : public ShapeVisitor {
 public:
  TriangleMesh mesh;

  void walk(Shape const& root) {
    open_.push_back({&root, Transform()});
    while (!open_.empty()) {
      auto const [shape, world_from_parent] = open_.back();
      open_.pop_back();
      world_from_shape_ = world_from_parent * shape->world_from_object();
      shape->accept(*this);
    }
  }

  void visit(Mesh const& shape) override {
    MeshGeometry const& geometry = *shape.geometry();
    auto const first = std::uint32_t(mesh.positions.size());
    for (Float3 const& p : geometry.positions) {
      Vec3 const q = world_from_shape_.point({p[0], p[1], p[2]});
      mesh.positions.push_back({float(q.x), float(q.y), float(q.z)});
    }
    for (std::size_t i = 0; i + 2 < geometry.indices.size(); i += 3) {
      mesh.triangles.push_back(
          {first + geometry.indices[i], first + geometry.indices[i + 1], first + geometry.indices[i + 2]});
    }
  }
  void visit(Composite const& composite) override {
    for (auto const& child : composite.children()) open_.emplace_back(child.get(), world_from_shape_);
  }
  void visit(Sphere const&) override {}
  void visit(Box const&) override {}
  void visit(Triangle const&) override {}

 private:
  std::vector<std::pair<Shape const*, Transform>> open_;
  Transform world_from_shape_;
};

}  // namespace

TriangleMesh read_mesh(std::string const& path) {
  Scene const scene = load_gltf(path);
  Collector collector;
  for (auto const& root : scene.roots()) collector.walk(*root);
  return std::move(collector.mesh);
}

}  // namespace lichtraum::bench
