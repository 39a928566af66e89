#pragma once

#include <glm/ext/quaternion_double.hpp>
#include <optional>
#include <vector>

#include "io/gltf/accessors.hpp"
#include "lichtraum/math.hpp"

namespace lichtraum::gltf {

/// Where a node stands below its parent, and how far its morph targets are.
struct NodePose {
  Vec3 translation{0};
  glm::dquat rotation{1, 0, 0, 0};
  Vec3 scale{1};
  std::optional<Mat4> matrix;   ///< instead of the three above
  std::vector<double> weights;  ///< one per morph target; empty: the mesh's own
  /// What an animation that was applied does to the node.
  bool is_moved = false;
  bool is_deformed = false;  ///< by weights

  Mat4 parent_from_node() const;
  void translate(Vec3 const& way);  ///< in its parent
  /// Into the three, for one of them to be animated. Shear is lost.
  void take_matrix_apart();
};

/// As the nodes stand in the file.
std::vector<NodePose> rest_pose(tinygltf::Model const& model, Findings& findings);

/// Moves what animation number `animation` moves to where it is at `seconds`; before its first and after its last key
/// frame it stands still (glTF 2.0, appendix C).
void apply_animation(tinygltf::Model const& model, int animation, double seconds, Accessors& accessors,
                     Findings& findings, std::vector<NodePose>& pose);

}  // namespace lichtraum::gltf
