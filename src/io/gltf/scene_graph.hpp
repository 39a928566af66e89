#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "io/gltf/deform.hpp"
#include "io/names.hpp"
#include "lichtraum/scene.hpp"

namespace lichtraum::gltf {

/// Turns the nodes of a model into composites and its meshes into Mesh, LineSet and PointCloud shapes. A mesh that
/// several nodes show is one shape with several parents, unless a skin or morph weights make it another one for each.
class SceneGraph {
 public:
  SceneGraph(Document const& document, NodeTree const& tree, std::vector<NodePose> const& pose, Primitives& primitives,
             Accessors& accessors, std::vector<std::shared_ptr<Material const>> const& materials, Names& names,
             Budget& budget, Findings& findings);

  /// Adds everything to `scene`, children before parents, below one root called `name`.
  void build(std::string const& name, Scene& scene);

  /// Primitives that could not be read although they should hold triangles, lines or points.
  std::size_t faulty_primitives() const { return faulty_primitives_; }
  std::uint64_t drawn() const { return drawn_; }  ///< primitives that show something, each once

 private:
  using Children = Composite::Children;

  /// By node: the shapes below it never move within it (Composite::moves_as_one). None without an animation.
  std::vector<bool> find_what_moves_as_one() const;
  std::vector<std::optional<Primitive>> const& primitives_of(int mesh);
  Children const& shared_shapes_of(int mesh, Scene& scene);
  Children shapes_of(int node, Scene& scene);
  Children deformed_shapes_of(int node, Scene& scene);
  Children instances_of(int node, Children const& shapes, Scene& scene);
  /// Counts a copy of a primitive's geometry.
  void charge_copy(int mesh, std::size_t primitive, MeshGeometry const& geometry);
  std::shared_ptr<Shape> add_mesh(int mesh, std::size_t primitive, std::shared_ptr<MeshGeometry const> geometry,
                                  Scene& scene);
  std::vector<double> const& weights_of(int node) const;
  std::string node_name(int node) const;

  Document const& document_;
  NodeTree const& tree_;
  std::vector<NodePose> const& pose_;
  Primitives& primitives_;
  Accessors& accessors_;
  std::vector<std::shared_ptr<Material const>> const& materials_;
  Names& names_;
  Budget& budget_;
  Findings& findings_;
  std::map<int, std::vector<std::optional<Primitive>>> meshes_;
  std::map<int, Children> shared_shapes_;
  std::map<int, SkinPose> skins_;
  std::vector<std::string> node_names_;
  std::size_t faulty_primitives_ = 0;
  std::uint64_t drawn_ = 0;
  bool has_left_out_ = false;
};

}  // namespace lichtraum::gltf
