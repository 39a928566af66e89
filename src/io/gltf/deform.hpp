#pragma once

#include <memory>

#include "io/gltf/node_tree.hpp"
#include "io/gltf/primitives.hpp"

namespace lichtraum::gltf {

/// The geometry with its morph targets added, each times its weight. The same pointer when no weight counts.
std::shared_ptr<MeshGeometry const> morph(Primitive const& primitive, std::vector<double> const& weights);

/// A skin's joints in the pose asked for.
struct SkinPose {
  std::vector<Mat4> world_from_bind;  ///< one per joint
  std::vector<Mat3> normals;          ///< their inverse transposes
};

SkinPose pose_skin(tinygltf::Model const& model, int skin, NodeTree const& tree, Accessors& accessors,
                   Findings& findings);

/// `geometry`, a primitive's own or morphed, moved by its joints; in the world. A joint that the skin lacks counts as
/// the first; a vertex without weights stays where it is.
std::shared_ptr<MeshGeometry const> apply_skin(MeshGeometry const& geometry, std::vector<JointSet> const& joint_sets,
                                               SkinPose const& skin);

}  // namespace lichtraum::gltf
