#include "mesh_file.hpp"

#include "lichtraum/gltf.hpp"

namespace lichtraum::bench {
namespace {

void add(Mesh const& shape, Transform const& world_from_shape, TriangleMesh& mesh) {
  MeshGeometry const& geometry = *shape.geometry();
  auto const first = std::uint32_t(mesh.positions.size());
  for (Float3 const& p : geometry.positions) {
    Vec3 const q = world_from_shape.point({p[0], p[1], p[2]});
    mesh.positions.push_back({float(q.x), float(q.y), float(q.z)});
  }
  for (std::size_t i = 0; i + 2 < geometry.indices.size(); i += 3) {
    mesh.triangles.push_back(
        {first + geometry.indices[i], first + geometry.indices[i + 1], first + geometry.indices[i + 2]});
  }
}

/// Puts every mesh below a shape into one, in the world.
void add_all(Shape const& root, TriangleMesh& mesh) {
  std::vector<std::pair<Shape const*, Transform>> open{{&root, Transform()}};
  while (!open.empty()) {
    auto const [shape, world_from_parent] = open.back();
    open.pop_back();
    Transform const world_from_shape = world_from_parent * shape->world_from_object();
    if (auto const* const found = dynamic_cast<Mesh const*>(shape)) add(*found, world_from_shape, mesh);
    if (auto const* const composite = dynamic_cast<Composite const*>(shape)) {
      for (auto const& child : composite->children()) open.emplace_back(child.get(), world_from_shape);
    }
  }
}

}  // namespace

TriangleMesh read_mesh(std::string const& path) {
  Scene const scene = load_gltf(path);
  TriangleMesh mesh;
  for (auto const& root : scene.roots()) add_all(*root, mesh);
  return mesh;
}

}  // namespace lichtraum::bench
