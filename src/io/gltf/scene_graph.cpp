#include "io/gltf/scene_graph.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>

#include "core/elementary.hpp"
#include "io/gltf/values.hpp"
#include "io/points.hpp"
#include "scene/graph_order.hpp"

namespace lichtraum::gltf {
namespace {

constexpr char const* instancing_extension = "EXT_mesh_gpu_instancing";

/// Composed of its parts where it can be, so that the inverse is exact. Nothing when it has no inverse.
std::optional<Transform> transform_of(NodePose const& pose) {
  try {
    if (pose.matrix) return Transform::from_matrix(*pose.matrix);
    Transform result = Transform::scaling(pose.scale);
    double const half_cosine = std::clamp(pose.rotation.w, -1.0, 1.0);
    Vec3 const axis(pose.rotation.x, pose.rotation.y, pose.rotation.z);
    if (axis != Vec3(0)) {
      double const angle = 2 * atan2_of(glm::length(axis), half_cosine);
      result = Transform::rotation(angle * 180 / 3.14159265358979323846, axis) * result;
    }
    return Transform::translation(pose.translation) * result;
  } catch (std::invalid_argument const&) {
    return std::nullopt;
  }
}

/// What no group has would be drawn where it was made.
void keep_only_what_is_below(std::shared_ptr<Composite const> const& root, Registry<std::shared_ptr<Shape>>& shapes) {
  GraphOrder const below = order_graph({root});
  Registry<std::shared_ptr<Shape>> kept;
  for (auto const& shape : shapes) {
    if (below.index.contains(shape.get())) kept.insert(shape);
  }
  shapes = std::move(kept);
}

std::string primitive_pointer(int mesh, std::size_t primitive) {
  return fmt::format("/meshes/{}/primitives/{}", mesh, primitive);
}

}  // namespace

SceneGraph::SceneGraph(Document const& document, NodeTree const& tree, std::vector<NodePose> const& pose,
                       Primitives& primitives, Accessors& accessors,
                       std::vector<std::shared_ptr<Material const>> const& materials, Names& names, Budget& budget,
                       Findings& findings)
    : document_(document),
      tree_(tree),
      pose_(pose),
      primitives_(primitives),
      accessors_(accessors),
      materials_(materials),
      names_(names),
      budget_(budget),
      findings_(findings) {}

std::string SceneGraph::node_name(int node) const {
  std::string const& name = document_.model.nodes[std::size_t(node)].name;
  return name.empty() ? fmt::format("node_{}", node) : name;
}

void SceneGraph::build(std::string const& name, Scene& scene) {
  // Nodes first: a node and its mesh often have one name, and people mean the node.
  std::string const root_name = names_.unique(name);
  node_names_.resize(document_.model.nodes.size());
  for (int const node : tree_.order) node_names_[std::size_t(node)] = names_.unique(node_name(node));

  std::vector<bool> const moves_as_one = find_what_moves_as_one();
  std::vector<std::shared_ptr<Composite>> composites(document_.model.nodes.size());
  Children skinned;  // in the world: what a joint moves, no parent moves
  for (auto node = tree_.order.rbegin(); node != tree_.order.rend(); ++node) {
    auto const i = std::size_t(*node);
    bool const is_skinned = document_.model.nodes[i].skin >= 0 && document_.model.nodes[i].mesh >= 0;
    Children children;
    if (is_skinned) {
      Children shapes = deformed_shapes_of(*node, scene);
      // Instances would need a skeleton each: what they are to be relative to is said nowhere.
      if (document_.model.nodes[i].extensions.contains(instancing_extension)) {
        findings_.warn(DiagnosticCode::unsupported_extension,
                       fmt::format("/nodes/{}/extensions/{}", *node, instancing_extension),
                       "a mesh that a skin bends has no instances here: one is drawn");
      }
      skinned.insert(skinned.end(), shapes.begin(), shapes.end());
    } else {
      children = shapes_of(*node, scene);
    }
    for (int const child : tree_.children[i]) {
      if (composites[std::size_t(child)]) children.push_back(composites[std::size_t(child)]);
    }
    if (children.empty()) continue;
    auto const transform = transform_of(pose_[i]);
    if (!transform) {
      findings_.warn(DiagnosticCode::faulty_node, fmt::format("/nodes/{}", *node),
                     "its transform has no inverse (a scale of zero?): left out");
      has_left_out_ = true;
      continue;
    }
    auto composite = std::make_shared<Composite>(node_names_[i], std::move(children));
    composite->set_world_from_object(*transform);
    composite->set_moves_as_one(moves_as_one[i]);
    scene.shapes.insert(composite);
    composites[i] = std::move(composite);
  }

  Children roots;
  for (int const root : tree_.roots) {
    if (composites[std::size_t(root)]) roots.push_back(composites[std::size_t(root)]);
  }
  roots.insert(roots.end(), skinned.begin(), skinned.end());
  auto const root = std::make_shared<Composite>(root_name, std::move(roots));
  if (has_left_out_) keep_only_what_is_below(root, scene.shapes);
  if (!root->children().empty()) scene.shapes.insert(root);
}

std::vector<bool> SceneGraph::find_what_moves_as_one() const {
  auto const is_animated = [](NodePose const& pose) { return pose.is_moved || pose.is_deformed; };
  if (std::none_of(pose_.begin(), pose_.end(), is_animated)) return std::vector<bool>(pose_.size(), false);
  std::vector<bool> found(pose_.size(), false);
  for (auto node = tree_.order.rbegin(); node != tree_.order.rend(); ++node) {  // children before their parents
    auto const i = std::size_t(*node);
    auto const stays = [&](int child) { return found[std::size_t(child)] && !pose_[std::size_t(child)].is_moved; };
    found[i] = !pose_[i].is_deformed && std::all_of(tree_.children[i].begin(), tree_.children[i].end(), stays);
  }
  return found;
}

std::vector<std::optional<Primitive>> const& SceneGraph::primitives_of(int mesh) {
  auto const [found, is_new] = meshes_.try_emplace(mesh);
  if (is_new) {
    for (std::size_t i = 0; i < document_.model.meshes[std::size_t(mesh)].primitives.size(); ++i) {
      found->second.push_back(primitives_.read(mesh, i));
      auto const& primitive = found->second.back();
      if (primitive) {
        ++drawn_;
      } else {
        ++faulty_primitives_;
      }
    }
  }
  return found->second;
}

std::vector<double> const& SceneGraph::weights_of(int node) const {
  auto const& own = pose_[std::size_t(node)].weights;
  return own.empty() ? document_.model.meshes[std::size_t(document_.model.nodes[std::size_t(node)].mesh)].weights : own;
}

void SceneGraph::charge_copy(int mesh, std::size_t primitive, MeshGeometry const& geometry) {
  std::uint64_t const vertices = geometry.positions.size();
  std::uint64_t numbers = geometry.indices.size() + geometry.lines.size();
  for (std::size_t const count : {geometry.positions.size(), geometry.normals.size()}) numbers += 3 * count;
  for (std::size_t const count : {geometry.tangents.size(), geometry.colors.size()}) numbers += 4 * count;
  numbers += 2 * vertices * geometry.texcoords.size();
  budget_.charge(sizeof(float) * numbers, primitive_pointer(mesh, primitive));
}

std::shared_ptr<Shape> SceneGraph::add_mesh(int mesh, std::size_t primitive,
                                            std::shared_ptr<MeshGeometry const> geometry, Scene& scene) {
  auto const& source = document_.model.meshes[std::size_t(mesh)];
  std::string name = source.name.empty() ? fmt::format("mesh_{}", mesh) : source.name;
  if (source.primitives.size() > 1) name += fmt::format(".{}", primitive);
  // A long name, for each primitive and each node: there in the shape, and among the names.
  budget_.charge(2 * name.size(), primitive_pointer(mesh, primitive));
  int const material = source.primitives[primitive].material;
  auto shape = make_shape(names_.unique(name), std::move(geometry),
                          material >= 0 ? materials_[std::size_t(material)] : materials_.back());
  scene.shapes.insert(shape);
  return shape;
}

SceneGraph::Children const& SceneGraph::shared_shapes_of(int mesh, Scene& scene) {
  auto const [found, is_new] = shared_shapes_.try_emplace(mesh);
  if (is_new) {
    auto const& primitives = primitives_of(mesh);
    auto const& weights = document_.model.meshes[std::size_t(mesh)].weights;
    for (std::size_t i = 0; i < primitives.size(); ++i) {
      if (!primitives[i]) continue;
      if (is_morphed(*primitives[i], weights)) charge_copy(mesh, i, *primitives[i]->geometry);
      found->second.push_back(add_mesh(mesh, i, morph(*primitives[i], weights), scene));
    }
  }
  return found->second;
}

SceneGraph::Children SceneGraph::deformed_shapes_of(int node, Scene& scene) {
  auto const& source = document_.model.nodes[std::size_t(node)];
  Children shapes;
  auto const& primitives = primitives_of(source.mesh);
  for (std::size_t i = 0; i < primitives.size(); ++i) {
    if (!primitives[i]) continue;
    bool const is_skinned = source.skin >= 0 && !primitives[i]->joint_sets.empty();
    if (is_skinned || is_morphed(*primitives[i], weights_of(node))) {
      charge_copy(source.mesh, i, *primitives[i]->geometry);
    }
    auto geometry = morph(*primitives[i], weights_of(node));
    if (source.skin >= 0) {
      auto const [skin, is_new] = skins_.try_emplace(source.skin);
      if (is_new) skin->second = pose_skin(document_.model, source.skin, tree_, accessors_, findings_);
      if (primitives[i]->joint_sets.empty() || skin->second.world_from_bind.empty()) {
        findings_.warn(DiagnosticCode::faulty_skin, fmt::format("/nodes/{}/skin", node),
                       "the mesh has no joints and weights for it");
      } else {
        bool const is_mirrored = glm::determinant(Mat3(tree_.world_from_node[std::size_t(node)])) < 0;
        geometry = apply_skin(*geometry, primitives[i]->joint_sets, skin->second, is_mirrored);
      }
    }
    shapes.push_back(add_mesh(source.mesh, i, std::move(geometry), scene));
  }
  return shapes;
}

SceneGraph::Children SceneGraph::shapes_of(int node, Scene& scene) {
  auto const& source = document_.model.nodes[std::size_t(node)];
  if (source.mesh < 0) return {};
  bool const has_own_weights = !pose_[std::size_t(node)].weights.empty() &&
                               weights_of(node) != document_.model.meshes[std::size_t(source.mesh)].weights;
  Children shapes = has_own_weights ? deformed_shapes_of(node, scene) : shared_shapes_of(source.mesh, scene);
  return source.extensions.contains(instancing_extension) ? instances_of(node, shapes, scene) : shapes;
}

SceneGraph::Children SceneGraph::instances_of(int node, Children const& shapes, Scene& scene) {
  auto const& extension = document_.model.nodes[std::size_t(node)].extensions.at(instancing_extension);
  std::string const pointer = fmt::format("/nodes/{}/extensions/{}/attributes", node, instancing_extension);
  tinygltf::Value const attributes = extension.Has("attributes") ? extension.Get("attributes") : tinygltf::Value();
  std::size_t count = 0;
  bool is_consistent = true;
  auto const read = [&](char const* name, std::size_t components) {
    std::optional<FloatElements> elements;
    if (!attributes.IsObject() || !attributes.Has(name)) return elements;
    auto const accessor = index_of(attributes, name, document_.model.accessors.size());
    elements = accessors_.floats(accessor.value_or(-1), components, fmt::format("{}/{}", pointer, name));
    std::size_t const found = elements ? elements->count() : 0;
    is_consistent = is_consistent && found > 0 && (count == 0 || count == found);
    count = found;
    return elements;
  };
  auto const translations = read("TRANSLATION", 3);
  auto const rotations = read("ROTATION", 4);
  auto const scales = read("SCALE", 3);
  if (count == 0 || !is_consistent) {
    findings_.warn(DiagnosticCode::faulty_node, pointer, "the instances cannot be read; one is drawn");
    return shapes;
  }
  // A composite, its transform, and its entries among the scene's shapes and the names, as it was measured.
  constexpr std::uint64_t instance_bytes = 512;
  std::string const& name = node_names_[std::size_t(node)];
  budget_.charge(count * (instance_bytes + 2 * name.size() + sizeof(std::shared_ptr<Shape>) * shapes.size()), pointer);
  Children instances;
  std::size_t left_out = 0;
  for (std::size_t i = 0; i < count; ++i) {
    NodePose pose;
    auto const vector = [i](FloatElements const& e) {
      return Vec3(e.values[3 * i], e.values[3 * i + 1], e.values[3 * i + 2]);
    };
    if (translations) pose.translation = vector(*translations);
    if (scales) pose.scale = vector(*scales);
    if (rotations) {
      float const* q = rotations->values.data() + 4 * i;
      glm::dquat const rotation(q[3], q[0], q[1], q[2]);
      if (glm::dot(rotation, rotation) > 0) pose.rotation = glm::normalize(rotation);
    }
    auto const transform = transform_of(pose);
    if (!transform || shapes.empty()) {
      ++left_out;
      continue;
    }
    auto composite = std::make_shared<Composite>(names_.unique(fmt::format("{}.{}", name, i)), shapes);
    composite->set_world_from_object(*transform);
    scene.shapes.insert(composite);
    instances.push_back(std::move(composite));
  }
  has_left_out_ = has_left_out_ || left_out > 0;
  if (left_out > 0)
    findings_.warn(DiagnosticCode::faulty_node, pointer,
                   fmt::format("{} of {} instances have no size: left out", left_out, count));
  return instances;
}

}  // namespace lichtraum::gltf
