#pragma once

#include <memory>

#include "io/gltf/node_tree.hpp"
#include "io/gltf/primitives.hpp"

namespace lichtraum::gltf {

/// Whether a weight counts.
bool is_morphed(Primitive const& primitive, std::vector<double> const& weights);
/// The geometry with its morph targets added, each times its weight. The same pointer where it is not morphed.
std::shared_ptr<MeshGeometry const> morph(Primitive const& primitive, std::vector<double> const& weights);

/// A skin's joints in the pose asked for.
struct SkinPose {
  std::vector<Mat4> world_from_bind;  ///< one per joint
  std::vector<Mat3> normals;          ///< their inverse transposes
};

SkinPose pose_skin(tinygltf::Model const& model, int skin, NodeTree const& tree, Accessors& accessors,
                   Findings& findings);

/// `geometry`, a primitive's own or morphed, moved by its joints; in the world. A joint that the skin lacks counts as
/// the first; a vertex without weights stays where it is. `is_mirrored`: the transform of the mesh's node, which moves
/// no vertex, is one of a negative determinant; it still turns the winding of triangles over (glTF 2.0, 3.7.2.1).
std::shared_ptr<MeshGeometry const> apply_skin(MeshGeometry const& geometry, std::vector<JointSet> const& joint_sets,
                                               SkinPose const& skin, bool is_mirrored);

}  // namespace lichtraum::gltf
