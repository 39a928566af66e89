#include "compile/object_compiler.hpp"

#include <algorithm>
#include <atomic>
#include <future>
#include <span>

#include "accel/crowding.hpp"
#include "accel/primitive_bounds.hpp"
#include "accel/wide_layout.hpp"
#include "core/parallel_ranges.hpp"
#include "core/start_threads.hpp"
#include "lichtraum/error.hpp"
#include "scene/device_conversion.hpp"

namespace lichtraum {
namespace {

template <class T, class Allocator>
void append(std::vector<T, Allocator>& all, std::vector<T, Allocator>&& more) {
  if (all.empty()) {
    all = std::move(more);
  } else {
    all.insert(all.end(), more.begin(), more.end());
  }
}

template <class T, class Allocator>
void append(std::vector<T, Allocator>& all, std::span<T const> more) {
  all.insert(all.end(), more.begin(), more.end());
}

bool is_unrepresentable(BuildPrimitive const& primitive) { return !primitive.bounds.is_finite(); }

/// Of what kernels meet by squares and products of coordinates, which beyond are infinite.
bool is_too_large(DeviceBounds const& bounds) {
  constexpr float largest = 1e18f;
  for (int axis = 0; axis < 3; ++axis) {
    if (!(bounds.min[axis] >= -largest && bounds.max[axis] <= largest)) return true;
  }
  return false;
}

/// The input of a hierarchy for a range of primitives of a kind. Returns how many are not representable.
template <class T>
std::uint64_t refer(BigVector<T> const& primitives, PrimitiveRange const& range, BuildPrimitive* out) {
  std::atomic<std::uint64_t> left_out = 0;
  for_parallel_ranges(range.count, 1 << 14, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      std::size_t const index = range.first + i;
      out[i] = {bounds_of(primitives[index]), {device::primitive_kind<T>, device::uint(index)}};
      constexpr bool is_squared =
          device::primitive_kind<T> == PRIMITIVE_TRIANGLE || device::primitive_kind<T> == PRIMITIVE_SPHERE;
      if (is_squared && is_too_large(out[i].bounds)) out[i].bounds = {};
    }
    left_out += std::uint64_t(std::count_if(out + begin, out + end, is_unrepresentable));
  });
  return left_out;
}

}  // namespace

std::unique_ptr<ObjectCompiler::Pending> ObjectCompiler::take(FlatObject&& object) {
  auto pending = std::make_unique<Pending>();
  pending->content.add(object.content);
  FirstOfObject const first{buffers_.triangles.size(), buffers_.spheres.size(), buffers_.ellipsoids.size(),
                            buffers_.cylinders.size()};
  device::for_each_kind(buffers_, object, [&]<class T>(BigVector<T>& all, BigVector<T>& more) {
    pending->ranges[device::primitive_kind<T>] = {all.size(), more.size()};
    append(all, std::move(more));
  });
  // Leaves name primitives by where they are in all of the scene.
  for (PrimitiveRange const& range : pending->ranges) pending->content.add(range.first);
  pending->content.add(buffers_.vertex_data.size());
  take_attributes(std::move(object), first);
  return pending;
}

CompiledObject const& ObjectCompiler::build(std::unique_ptr<Pending> pending) {
  ContentHash const content = pending->content.finish();
  CompiledObject const* const known = find_in_previous(content);
  PrimitiveRanges const ranges = pending->ranges;
  CompiledObject object = known ? copy(*known) : add(std::move(*pending));
  object.content = content;
  object.ranges = ranges;
  buffers_.unrepresentable += object.unrepresentable;
  buffers_.objects.push_back(object);
  return buffers_.objects.back();
}

void ObjectCompiler::add_instance(std::size_t number, FlatInstance const& instance, CompiledObject const& object,
                                  Pending& world) {
  DeviceBounds bounds = map_bounds(instance.world_from_object, object.bounds);
  if (object.is_unbounded && !bounds.is_finite()) bounds = {};
  if (!object.is_unbounded && bounds.is_empty()) return;
  auto& instances = object.is_unbounded ? world.unbounded_instances : world.instances;
  instances.push_back({bounds, {PRIMITIVE_INSTANCE, device::uint(buffers_.instances.size())}});
  device::Instance const placed{device_transform(instance.world_from_object.inverse()), object.root_node, {}};
  world.content.add(placed.object_from_world);
  world.content.add(bounds);
  world.content.add(object.is_unbounded);
  world.content.add(object.stack_size);
  world.content.add(object.crowding);
  buffers_.instances.push_back(placed);
  instances_crowding_.push_back(object.crowding);
  instances_stack_sizes_.push_back(object.stack_size);
  buffers_.flat_instances.push_back(device::uint(number));
}

void ObjectCompiler::note_features() {
  device::for_each_kind(buffers_, [&]<class T>(BigVector<T> const& primitives) {
    bool const is_rare = device::primitive_kind<T> >= FIRST_RARE_SHAPE;
    if (is_rare && !primitives.empty()) buffers_.shading.features |= SCENE_RARE_SHAPES;
  });
}

void ObjectCompiler::finish() {
  if (buffers_.vertex_data.empty()) return;
  if (buffers_.layout == TreeLayout::binary) {
    attributes_.resize(buffers_.triangles.size(), {});
    buffers_.triangle_attributes = std::move(attributes_);
    sphere_colors_.resize(buffers_.spheres.size(), 0);
    buffers_.sphere_colors = std::move(sphere_colors_);
  } else {
    buffers_.triangle_attributes.resize(buffers_.triangle_tags.size(), {});
    buffers_.sphere_colors.resize(BLOCK_LANES * buffers_.sphere_blocks.size(), 0);
  }
  buffers_.ellipsoid_colors.resize(buffers_.ellipsoids.size(), 0);
  buffers_.cylinder_colors.resize(buffers_.cylinders.size(), 0);
  buffers_.shading.features |= SCENE_ATTRIBUTES;
}

void ObjectCompiler::take_attributes(FlatObject&& object, FirstOfObject const& first_of) {
  if (object.vertex_data.empty()) return;
  std::size_t const first = buffers_.vertex_data.size();
  if (first + object.vertex_data.size() > 0xFFFFFFFFu) {
    throw Error(ErrorKind::scene, "the meshes' normals, colours and texture coordinates need more than 2^32 floats");
  }
  for (device::TriangleAttributes& triangle : object.triangle_attributes) {
    for (device::uint& corner : triangle.corners) corner += device::uint(first);
  }
  auto const take_colors = [&](BigVector<device::uint>&& colors, std::size_t first_primitive, auto& all) {
    if (colors.empty()) return;
    for (device::uint& color : colors) color += color != 0 ? device::uint(first) : 0;
    all.resize(first_primitive, 0);
    append(all, std::move(colors));
  };
  take_colors(std::move(object.sphere_colors), first_of.sphere, sphere_colors_);
  take_colors(std::move(object.ellipsoid_colors), first_of.ellipsoid, buffers_.ellipsoid_colors);
  take_colors(std::move(object.cylinder_colors), first_of.cylinder, buffers_.cylinder_colors);
  if (!object.triangle_attributes.empty()) {
    attributes_.resize(first_of.triangle, {});
    append(attributes_, std::move(object.triangle_attributes));
  }
  append(buffers_.vertex_data, std::move(object.vertex_data));
}

CompiledObject ObjectCompiler::add(Pending&& pending) {
  std::size_t count = pending.instances.size();
  for (PrimitiveRange const& range : pending.ranges) count += range.count;
  BigVector<BuildPrimitive> all(count);
  std::vector<BuildPrimitive> unbounded = std::move(pending.unbounded_instances);
  BuildPrimitive* out = all.data();
  std::uint64_t left_out = 0;
  device::for_each_kind(buffers_, [&]<class T>(BigVector<T> const& primitives) {
    PrimitiveRange const& range = pending.ranges[device::primitive_kind<T>];
    if constexpr (device::primitive_kind<T> == PRIMITIVE_PLANE) {
      for (std::size_t i = 0; i < range.count; ++i) {
        unbounded.push_back({{}, {PRIMITIVE_PLANE, device::uint(range.first + i)}});
      }
    } else {
      left_out += refer(primitives, range, out);
      out += range.count;
    }
  });
  auto const& instances = pending.instances;
  out = std::copy(instances.begin(), instances.end(), out);
  all.resize(std::size_t(out - all.data()));
  left_out += std::uint64_t(std::count_if(instances.begin(), instances.end(), is_unrepresentable));
  if (left_out > 0) std::erase_if(all, is_unrepresentable);
  Bvh bvh = build_bvh(all, unbounded);
  // Beside what follows, some of which takes one thread.
  auto crowds = std::async(thread_if_any, [&] { return crowding(bvh, instances_crowding_); });
  bool const is_binary = buffers_.layout == TreeLayout::binary;
  if (is_binary) crowds.wait();  // as the hierarchy goes
  CompiledObject object = is_binary ? add_binary(std::move(bvh)) : add_wide(bvh);
  object.crowding = crowds.get();
  object.is_unbounded = !unbounded.empty();
  object.unrepresentable = left_out;
  return object;
}

CompiledObject const* ObjectCompiler::find_in_previous(ContentHash const& content) const {
  if (!previous_ || previous_->layout != buffers_.layout) return nullptr;
  auto const found = std::find_if(previous_->objects.begin(), previous_->objects.end(),
                                  [&](CompiledObject const& object) { return object.content == content; });
  return found == previous_->objects.end() ? nullptr : &*found;
}

CompiledObject ObjectCompiler::add_binary(Bvh&& bvh) {
  CompiledObject object;
  object.root_node = device::uint(buffers_.nodes.size());
  object.node_count = device::uint(bvh.nodes.size());
  object.first_leaf = device::uint(buffers_.references.size());
  object.leaf_count = device::uint(bvh.references.size());
  object.bounds = bvh.bounds;
  append(buffers_.nodes, std::move(bvh.nodes));
  append(buffers_.references, std::move(bvh.references));
  move_nodes(object, object.root_node, object.first_leaf, 0);
  return object;
}

CompiledObject ObjectCompiler::add_wide(Bvh const& bvh) {
  WideBvh wide = collapse(bvh, instances_stack_sizes_);
  CompiledObject object;
  object.root_node = device::uint(buffers_.wide_nodes.size());
  object.node_count = device::uint(wide.nodes.size());
  object.first_leaf = device::uint(buffers_.triangle_blocks.size());
  object.leaf_count = device::uint(wide.triangle_blocks.size());
  object.bounds = bvh.bounds;
  object.stack_size = wide.stack_size;
  object.first_sphere_block = device::uint(buffers_.sphere_blocks.size());
  object.sphere_block_count = device::uint(wide.sphere_blocks.size());
  buffers_.sphere_blocks.resize(object.first_sphere_block + wide.sphere_blocks.size());
  fill_sphere_blocks(wide.sphere_blocks, bvh.references, buffers_.spheres,
                     std::span(buffers_.sphere_blocks).subspan(object.first_sphere_block));
  if (!sphere_colors_.empty()) {
    buffers_.sphere_colors.resize(BLOCK_LANES * buffers_.sphere_blocks.size(), 0);
    fill_block_attributes(wide.sphere_blocks, bvh.references, sphere_colors_,
                          std::span(buffers_.sphere_colors).subspan(BLOCK_LANES * object.first_sphere_block));
  }
  append(buffers_.wide_nodes, std::move(wide.nodes));
  move_nodes(object, object.root_node, object.first_leaf, object.first_sphere_block);
  buffers_.triangle_blocks.resize(object.first_leaf + wide.triangle_blocks.size());
  buffers_.triangle_tags.resize(BLOCK_LANES * buffers_.triangle_blocks.size());
  fill_triangle_blocks(wide.triangle_blocks, bvh.references, buffers_.triangles,
                       std::span(buffers_.triangle_blocks).subspan(object.first_leaf),
                       std::span(buffers_.triangle_tags).subspan(BLOCK_LANES * object.first_leaf));
  if (!attributes_.empty()) {
    buffers_.triangle_attributes.resize(buffers_.triangle_tags.size(), {});
    fill_block_attributes(wide.triangle_blocks, bvh.references, attributes_,
                          std::span(buffers_.triangle_attributes).subspan(BLOCK_LANES * object.first_leaf));
  }
  return object;
}

CompiledObject ObjectCompiler::copy(CompiledObject const& known) {
  CompiledObject object = known;
  auto const part = [](auto const& all, std::size_t first, std::size_t count) {
    return std::span(all).subspan(first, count);
  };
  if (buffers_.layout == TreeLayout::binary) {
    object.root_node = device::uint(buffers_.nodes.size());
    object.first_leaf = device::uint(buffers_.references.size());
    append(buffers_.nodes, part(previous_->nodes, known.root_node, known.node_count));
    append(buffers_.references, part(previous_->references, known.first_leaf, known.leaf_count));
  } else {
    object.root_node = device::uint(buffers_.wide_nodes.size());
    object.first_leaf = device::uint(buffers_.triangle_blocks.size());
    object.first_sphere_block = device::uint(buffers_.sphere_blocks.size());
    append(buffers_.sphere_blocks, part(previous_->sphere_blocks, known.first_sphere_block, known.sphere_block_count));
    append(buffers_.wide_nodes, part(previous_->wide_nodes, known.root_node, known.node_count));
    append(buffers_.triangle_blocks, part(previous_->triangle_blocks, known.first_leaf, known.leaf_count));
    append(buffers_.triangle_tags,
           part(previous_->triangle_tags, BLOCK_LANES * known.first_leaf, BLOCK_LANES * known.leaf_count));
    if (!attributes_.empty() && !previous_->triangle_attributes.empty()) {
      buffers_.triangle_attributes.resize(BLOCK_LANES * object.first_leaf, {});
      append(buffers_.triangle_attributes,
             part(previous_->triangle_attributes, BLOCK_LANES * known.first_leaf, BLOCK_LANES * known.leaf_count));
    }
    if (!sphere_colors_.empty() && !previous_->sphere_colors.empty()) {
      buffers_.sphere_colors.resize(BLOCK_LANES * object.first_sphere_block, 0);
      append(buffers_.sphere_colors, part(previous_->sphere_colors, BLOCK_LANES * known.first_sphere_block,
                                          BLOCK_LANES * known.sphere_block_count));
    }
  }
  move_nodes(object, object.root_node - known.root_node, object.first_leaf - known.first_leaf,
             object.first_sphere_block - known.first_sphere_block);
  return object;
}

void ObjectCompiler::move_nodes(CompiledObject const& object, device::uint nodes, device::uint leaves,
                                device::uint sphere_blocks) {
  if (buffers_.layout == TreeLayout::binary) {
    for (device::BvhNode& node : std::span(buffers_.nodes).subspan(object.root_node, object.node_count)) {
      for (device::BvhChild& child : node.children) child.first += child.count == 0 ? nodes : leaves;
    }
    return;
  }
  for (device::WideNode& node : std::span(buffers_.wide_nodes).subspan(object.root_node, object.node_count)) {
    for (device::uint& child : node.children) {
      device::uint const kind = child >> WIDE_INDEX_BITS;
      if (kind == WIDE_KIND_NODE) child += nodes;
      if (kind == PRIMITIVE_TRIANGLE) child += leaves;
      if (kind == PRIMITIVE_SPHERE) child += sphere_blocks;
    }
  }
}

}  // namespace lichtraum
