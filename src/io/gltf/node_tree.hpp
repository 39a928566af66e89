#pragma once

#include <vector>

#include "io/gltf/pose.hpp"

namespace lichtraum::gltf {

/// The nodes as a forest, whatever the file says: each node has one parent at most and is not its own ancestor. Edges
/// that break this are findings and left out.
struct NodeTree {
  std::vector<int> roots;                  ///< of the scene
  std::vector<std::vector<int>> children;  ///< of each node, but for those that are invisible
  std::vector<int> order;                  ///< every visible node of the scene, parents first
  std::vector<int> placed;                 ///< the same with those that KHR_node_visibility hides: cameras may be there
  std::vector<Mat4> world_from_node;       ///< of every node, also of those in no scene (joints may be there)
};

/// By node: whether it is another one's child.
std::vector<bool> find_children(tinygltf::Model const& model);

/// `scene`: index, or -1 for all nodes that have no parent.
NodeTree build_node_tree(tinygltf::Model const& model, int scene, std::vector<NodePose> const& pose,
                         Findings& findings);

}  // namespace lichtraum::gltf
