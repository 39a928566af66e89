#include "io/gltf/node_tree.hpp"

#include <fmt/format.h>

#include "io/gltf/values.hpp"

namespace lichtraum::gltf {
namespace {

bool is_visible(tinygltf::Node const& node) {
  auto const* extension = find_extension(node.extensions, "KHR_node_visibility");
  if (!extension || !extension->Has("visible") || !extension->Get("visible").IsBool()) return true;
  return extension->Get("visible").Get<bool>();
}

class Builder {
 public:
  Builder(tinygltf::Model const& model, std::vector<NodePose> const& pose, Findings& findings)
      : model_(model), pose_(pose), findings_(findings), is_taken_(model.nodes.size(), false) {
    tree_.children.resize(model.nodes.size());
    tree_.world_from_node.resize(model.nodes.size(), Mat4(1));
  }

  NodeTree build(int scene) {
    std::vector<bool> const is_child = find_children(model_);
    std::vector<int> roots;
    if (scene >= 0) {
      roots = model_.scenes[std::size_t(scene)].nodes;
    } else {
      for (std::size_t i = 0; i < is_child.size(); ++i) {
        if (!is_child[i]) roots.push_back(int(i));
      }
    }
    for (int const root : roots) {
      if (!claim(root)) continue;
      tree_.roots.push_back(root);
      walk(root, true);
    }
    // What is in no scene is not drawn, but may be a joint.
    for (std::size_t i = 0; i < is_child.size(); ++i) {
      if (!is_child[i] && !is_taken_[i]) {
        is_taken_[i] = true;
        walk(int(i), false);
      }
    }
    return std::move(tree_);
  }

 private:
  bool claim(int node) {
    if (is_taken_[std::size_t(node)]) {
      findings_.warn(DiagnosticCode::faulty_node, fmt::format("/nodes/{}", node),
                     "it occurs twice in the node tree; only the first occurrence counts");
      return false;
    }
    is_taken_[std::size_t(node)] = true;
    return true;
  }

  /// Places `root` and all below it. What is in no scene is in no order.
  void walk(int root, bool is_in_scene) {
    struct Open {
      int node;
      bool is_visible;  ///< so is all above it
    };
    tree_.world_from_node[std::size_t(root)] = pose_[std::size_t(root)].parent_from_node();
    std::vector<Open> open{{root, is_visible(model_.nodes[std::size_t(root)])}};
    while (!open.empty()) {
      Open const top = open.back();
      open.pop_back();
      auto const i = std::size_t(top.node);
      if (is_in_scene) tree_.placed.push_back(top.node);
      if (is_in_scene && top.is_visible) tree_.order.push_back(top.node);
      for (int const child : model_.nodes[i].children) {
        if (!claim(child)) continue;
        tree_.world_from_node[std::size_t(child)] =
            tree_.world_from_node[i] * pose_[std::size_t(child)].parent_from_node();
        bool const is_child_visible = top.is_visible && is_visible(model_.nodes[std::size_t(child)]);
        if (is_child_visible) tree_.children[i].push_back(child);
        open.push_back({child, is_child_visible});
      }
    }
  }

  tinygltf::Model const& model_;
  std::vector<NodePose> const& pose_;
  Findings& findings_;
  std::vector<bool> is_taken_;
  NodeTree tree_;
};

}  // namespace

std::vector<bool> find_children(tinygltf::Model const& model) {
  std::vector<bool> is_child(model.nodes.size(), false);
  for (auto const& node : model.nodes) {
    for (int const child : node.children) is_child[std::size_t(child)] = true;
  }
  return is_child;
}

NodeTree build_node_tree(tinygltf::Model const& model, int scene, std::vector<NodePose> const& pose,
                         Findings& findings) {
  return Builder(model, pose, findings).build(scene);
}

}  // namespace lichtraum::gltf
