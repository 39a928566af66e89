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
    std::vector<bool> is_child(model_.nodes.size(), false);
    for (auto const& node : model_.nodes) {
      for (int const child : node.children) is_child[std::size_t(child)] = true;
    }
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
      walk(root, tree_.order);
    }
    // What is in no scene is not drawn, but may be a joint.
    std::vector<int> unseen;
    for (std::size_t i = 0; i < is_child.size(); ++i) {
      if (!is_child[i] && !is_taken_[i]) {
        is_taken_[i] = true;
        walk(int(i), unseen);
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

  /// Appends `root` and all below it, parents first.
  void walk(int root, std::vector<int>& order) {
    tree_.world_from_node[std::size_t(root)] = pose_[std::size_t(root)].parent_from_node();
    if (!is_visible(model_.nodes[std::size_t(root)])) return;
    std::vector<int> open{root};
    while (!open.empty()) {
      int const node = open.back();
      open.pop_back();
      order.push_back(node);
      for (int const child : model_.nodes[std::size_t(node)].children) {
        if (!claim(child)) continue;
        tree_.world_from_node[std::size_t(child)] =
            tree_.world_from_node[std::size_t(node)] * pose_[std::size_t(child)].parent_from_node();
        if (!is_visible(model_.nodes[std::size_t(child)])) continue;
        tree_.children[std::size_t(node)].push_back(child);
        open.push_back(child);
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

NodeTree build_node_tree(tinygltf::Model const& model, int scene, std::vector<NodePose> const& pose,
                         Findings& findings) {
  return Builder(model, pose, findings).build(scene);
}

}  // namespace lichtraum::gltf
