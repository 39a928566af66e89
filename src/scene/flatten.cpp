#include "scene/flatten.hpp"

#include <fmt/format.h>

#include <unordered_map>

#include "core/memory.hpp"
#include "scene/bake.hpp"
#include "scene/graph_order.hpp"
#include "scene/scene_content.hpp"

namespace lichtraum {
namespace {

/// Below this an instance (its matrix, its entry in the hierarchy, the second traversal) costs more than a copy.
constexpr std::uint64_t min_object_primitives = 8;
/// Up to this, an object is unfolded although something inside it is shared as well: instances do not nest.
constexpr std::uint64_t max_unfolded_primitives = 1 << 16;

/// Below this, building the hierarchy of what moves as one again (2 ms) is not worth a second level for its rays.
constexpr std::uint64_t min_moving_primitives = 4096;

bool is_worth_a_hierarchy(GraphNode const& node) {
  if (node.occurrences > 1) return node.primitives >= min_object_primitives;
  return node.composite && node.composite->moves_as_one() && node.primitives >= min_moving_primitives;
}

/// Which composites and meshes become objects: of those that occur several times or move as one, the topmost that hold
/// a plain tree or little. Never how often a scene is drawn: a picture has the same bytes alone and in a sequence.
bool becomes_object(GraphNode const& node) {
  return is_worth_a_hierarchy(node) && (node.is_tree || node.primitives <= max_unfolded_primitives);
}

struct UnfoldedCounts {
  std::uint64_t primitives = 0;
  std::uint64_t instances = 0;
};

UnfoldedCounts count_unfolded(GraphOrder const& order, std::vector<std::shared_ptr<Shape const>> const& roots) {
  UnfoldedCounts counts;
  std::vector<std::uint64_t> paths(order.nodes.size(), 0);  // to each node, from a root, through no object
  auto const arrive = [&](Shape const& shape, std::uint64_t count) {
    std::uint64_t& sum = is_graph_node(shape) ? paths[order.index.at(&shape)] : counts.primitives;
    sum = saturating_add(sum, count);
  };
  for (auto const& root : roots) arrive(*root, 1);
  for (std::size_t i = order.nodes.size(); i-- > 0;) {  // parents first
    GraphNode const& node = order.nodes[i];
    if (paths[i] == 0) continue;
    if (becomes_object(node)) {
      counts.instances = saturating_add(counts.instances, paths[i]);
      counts.primitives = saturating_add(counts.primitives, node.primitives);
    } else if (node.composite) {
      for (auto const& child : node.composite->children()) arrive(*child, paths[i]);
    } else {
      counts.primitives = saturating_add(counts.primitives, saturating_multiply(node.primitives, paths[i]));
    }
  }
  return counts;
}

/// Refuses what would not fit this machine's memory, before a byte of it is taken.
void check_size(UnfoldedCounts const& counts) {
  // Per element: the device's struct, its reference and bounds while the hierarchy is built, its share of the nodes.
  constexpr std::uint64_t bytes_per_primitive = 44 + 40 + 64;
  constexpr std::uint64_t bytes_per_instance = 264 + 64 + 40 + 64;
  auto const needed = saturating_add(saturating_multiply(counts.primitives, bytes_per_primitive),
                                     saturating_multiply(counts.instances, bytes_per_instance));
  auto const memory = usable_memory_bytes();
  constexpr std::uint64_t max_index = 0xFFFFFFFFu;  // indices on the device have 32 bits
  if (needed <= memory && saturating_add(counts.primitives, counts.instances) < max_index) return;
  auto const shown = [](std::uint64_t count) {
    return count >= GraphNode::uncountable ? std::string("more than 10^18") : fmt::format("{}", count);
  };
  throw Error(ErrorKind::scene,
              fmt::format("the scene unfolds to {} primitives and {} instances, which need {} of memory; {} can be "
                          "used here. Use fewer instances of composites in composites.",
                          shown(counts.primitives), shown(counts.instances),
                          needed >= GraphNode::uncountable ? "more than 10^18 bytes" : bytes_text(double(needed)),
                          bytes_text(double(memory))));
}

class Flattener {
 public:
  explicit Flattener(std::vector<std::shared_ptr<Shape const>> const& roots) : order_(order_graph(roots)) {
    check_size(count_unfolded(order_, roots));
    scene_.objects.emplace_back();
    for (auto const& root : roots) unfold(*root, Transform(), 0);
    scene_.objects[0].shape_count = scene_.shapes.size();
    // Objects are found while the world is unfolded; inside them nothing is an instance.
    for (std::size_t i = 0; i < object_roots_.size(); ++i) {
      scene_.objects.emplace_back();
      std::size_t const first_shape = scene_.shapes.size();
      unfold_object(*object_roots_[i], i + 1);
      scene_.objects.back().first_shape = first_shape;
      scene_.objects.back().shape_count = scene_.shapes.size() - first_shape;
    }
    for (FlatObject& object : scene_.objects) object.content = content_of(object);
  }

  FlatScene take() { return std::move(scene_); }

 private:
  /// A composite whose children are being unfolded.
  struct Open {
    Composite const* composite;
    std::size_t next_child;
    Transform object_from_composite;
  };

  /// In the object's own frame: its transform is in each instance.
  void unfold_object(Shape const& shape, std::size_t object) {
    if (auto const* composite = as_composite(shape)) {
      for (auto const& child : composite->children()) unfold(*child, Transform(), object);
    } else {
      add_leaf(shape, Transform(), object);
    }
  }

  void unfold(Shape const& root, Transform const& object_from_parent, std::size_t object) {
    open_.clear();
    arrive(root, object_from_parent, object);
    while (!open_.empty()) {
      Open& top = open_.back();
      if (top.next_child == top.composite->children().size()) {
        open_.pop_back();
        continue;
      }
      Shape const& child = *top.composite->children()[top.next_child++];
      arrive(child, Transform(top.object_from_composite), object);  // a copy: arrive may move the stack
    }
  }

  void arrive(Shape const& shape, Transform const& object_from_parent, std::size_t object) {
    Transform const object_from_shape = object_from_parent * shape.world_from_object();
    if (object == 0 && is_graph_node(shape) && becomes_object(order_[&shape])) {
      scene_.instances.push_back({object_of(shape), object_from_shape, scene_.shapes.size()});
    } else if (auto const* composite = as_composite(shape)) {
      open_.push_back({composite, 0, object_from_shape});
    } else {
      add_leaf(shape, object_from_shape, object);
    }
  }

  void add_leaf(Shape const& shape, Transform const& object_from_shape, std::size_t object) {
    scene_.unrepresentable += bake(shape, object_from_shape, tag_of(shape), scene_.objects[object]);
  }

  /// The number of the object that shows `shape` in its own frame (each instance has the shape's transform).
  std::uint32_t object_of(Shape const& shape) {
    auto const [found, is_new] = object_numbers_.emplace(&shape, std::uint32_t(object_roots_.size() + 1));
    if (is_new) object_roots_.push_back(&shape);
    return found->second;
  }

  device::PrimitiveTag tag_of(Shape const& shape) {
    scene_.shapes.push_back(&shape);
    return {material_number(shape.material()), std::uint32_t(scene_.shapes.size() - 1)};
  }

  std::uint32_t material_number(std::shared_ptr<Material const> const& material) {
    auto const [found, is_new] = material_numbers_.emplace(material.get(), std::uint32_t(scene_.materials.size()));
    if (is_new) scene_.materials.push_back(material);
    return found->second;
  }

  GraphOrder order_;
  FlatScene scene_;
  std::vector<Open> open_;
  std::vector<Shape const*> object_roots_;
  std::unordered_map<Shape const*, std::uint32_t> object_numbers_;
  std::unordered_map<Material const*, std::uint32_t> material_numbers_;
};

}  // namespace

FlatScene flatten(std::vector<std::shared_ptr<Shape const>> const& roots) { return Flattener(roots).take(); }

}  // namespace lichtraum
