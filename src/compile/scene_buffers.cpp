#include "compile/scene_buffers.hpp"

#include <iterator>

#include "accel/bvh.hpp"
#include "accel/primitive_bounds.hpp"
#include "accel/wide_layout.hpp"
#include "scene/device_conversion.hpp"

namespace lichtraum {
namespace {

template <class T>
void append(std::vector<T>& all, std::vector<T>&& more) {
  if (all.empty()) {
    all = std::move(more);
  } else {
    all.insert(all.end(), more.begin(), more.end());
  }
}

class Compiler {
 public:
  explicit Compiler(Traversal traversal) { buffers_.traversal = traversal; }

  /// Moves the object's primitives into the buffers; returns its hierarchy's input.
  std::vector<BuildPrimitive> take(FlatObject&& object) {
    std::vector<BuildPrimitive> all;
    all.reserve(object.primitive_count());
    refer(object.triangles, PRIMITIVE_TRIANGLE, buffers_.triangles.size(), all);
    refer(object.spheres, PRIMITIVE_SPHERE, buffers_.spheres.size(), all);
    refer(object.ellipsoids, PRIMITIVE_ELLIPSOID, buffers_.ellipsoids.size(), all);
    refer(object.boxes, PRIMITIVE_BOX, buffers_.boxes.size(), all);
    append(buffers_.triangles, std::move(object.triangles));
    append(buffers_.spheres, std::move(object.spheres));
    append(buffers_.ellipsoids, std::move(object.ellipsoids));
    append(buffers_.boxes, std::move(object.boxes));
    return all;
  }

  struct Object {
    device::uint root_node;
    Bounds bounds;
    std::size_t stack_size = 0;
  };

  Object build(std::vector<BuildPrimitive>&& primitives) {
    Bvh bvh = build_bvh(std::move(primitives));
    if (buffers_.traversal != Traversal::scalar) return add_wide(bvh);
    auto const first_node = device::uint(buffers_.nodes.size());
    auto const first_reference = device::uint(buffers_.references.size());
    for (device::BvhNode& node : bvh.nodes) {
      for (device::BvhChild& child : node.children) child.first += child.count == 0 ? first_node : first_reference;
    }
    append(buffers_.nodes, std::move(bvh.nodes));
    append(buffers_.references, std::move(bvh.references));
    return {first_node, bvh.bounds, 0};
  }

  /// Adds a thing to a hierarchy's input, unless its bounds do not fit a float.
  void refer(Bounds const& bounds, device::PrimitiveReference reference, std::vector<BuildPrimitive>& out) {
    if (bounds.is_finite()) {
      out.push_back({bounds, reference});
    } else {
      ++buffers_.unrepresentable;
    }
  }

  SceneBuffers& buffers() { return buffers_; }

 private:
  Object add_wide(Bvh const& bvh) {
    WideBvh wide = collapse(bvh);
    auto const first_node = device::uint(buffers_.wide_nodes.size());
    auto const first_block = device::uint(buffers_.triangle_blocks.size());
    for (device::WideNode& node : wide.nodes) {
      for (device::uint& child : node.children) {
        device::uint const kind = child >> WIDE_INDEX_BITS;
        if (kind == WIDE_KIND_NODE) child += first_node;
        if (kind == PRIMITIVE_TRIANGLE) child += first_block;
      }
    }
    append(buffers_.wide_nodes, std::move(wide.nodes));
    buffers_.triangle_blocks.resize(first_block + wide.blocks.size());
    buffers_.triangle_tags.resize(BLOCK_LANES * buffers_.triangle_blocks.size());
    fill_blocks(wide.blocks, bvh.references, buffers_.triangles,
                std::span(buffers_.triangle_blocks).subspan(first_block),
                std::span(buffers_.triangle_tags).subspan(BLOCK_LANES * first_block));
    return {first_node, bvh.bounds, wide.stack_size};
  }

  template <class T>
  void refer(std::vector<T> const& primitives, device::uint kind, std::size_t first, std::vector<BuildPrimitive>& out) {
    for (std::size_t i = 0; i < primitives.size(); ++i) {
      refer(bounds_of(primitives[i]), {kind, device::uint(first + i)}, out);
    }
  }

  SceneBuffers buffers_;
};

/// Whether rays from the point resolve the scene: their t has 24 bits for all of the distance.
bool is_near(Vec3 const& point, Bounds const& bounds) {
  constexpr double max_distance = 16;  // in diagonals of the scene
  if (bounds.is_empty()) return false;
  Vec3 const min(bounds.min[0], bounds.min[1], bounds.min[2]), max(bounds.max[0], bounds.max[1], bounds.max[2]);
  return glm::distance(point, 0.5 * (min + max)) <= max_distance * glm::distance(min, max);
}

device::PhongMaterial device_material(Material const& material) {
  device::PhongMaterial out{};
  out.ka = device_float4(material.ka(), material.m());
  out.kd = device_float4(material.kd(), material.reflect());
  out.ks = device_float4(material.ks(), material.transmit());
  out.ior = float(material.ior());
  store(material.emission(), out.emission);
  return out;
}

}  // namespace

SceneBuffers compile_scene(FlatScene&& scene, Registry<Light> const& lights, Traversal traversal) {
  Compiler compiler(traversal);
  std::vector<BuildPrimitive> world = compiler.take(std::move(scene.objects[0]));
  std::vector<Compiler::Object> objects(1);  // the world's comes last: it needs the others' bounds
  for (std::size_t i = 1; i < scene.objects.size(); ++i) {
    objects.push_back(compiler.build(compiler.take(std::move(scene.objects[i]))));
  }
  SceneBuffers& buffers = compiler.buffers();
  for (FlatInstance const& instance : scene.instances) {
    Compiler::Object const& object = objects[instance.object];
    Bounds const bounds = map_bounds(instance.world_from_object, object.bounds);
    if (bounds.is_empty()) continue;
    compiler.refer(bounds, {PRIMITIVE_INSTANCE, device::uint(buffers.instances.size())}, world);
    buffers.instances.push_back({device_transform(instance.world_from_object.inverse()), object.root_node, {}});
  }
  Compiler::Object const built = compiler.build(std::move(world));
  buffers.root_node = built.root_node;
  buffers.world_bounds = built.bounds;
  std::size_t deepest_object = 0;
  for (Compiler::Object const& object : objects) deepest_object = std::max(deepest_object, object.stack_size);
  buffers.stack_size = built.stack_size + deepest_object;
  buffers.triangle_count = buffers.triangles.size();
  if (traversal != Traversal::scalar) buffers.triangles = {};  // they are in the blocks
  for (auto const& material : scene.materials) {
    buffers.materials.push_back(device_material(material ? *material : Material()));
    buffers.has_transparency = buffers.has_transparency || buffers.materials.back().ks.w > 0;
  }
  for (Light const& light : lights) {
    if (light.kind() == LightKind::point) {
      bool const near = is_near(light.position(), buffers.world_bounds);
      buffers.lights.push_back({device_float4(light.position(), near ? 1 : 0), device_float4(light.ld())});
    }
  }
  buffers.shapes = std::move(scene.shapes);
  buffers.unrepresentable += scene.unrepresentable;
  return std::move(buffers);
}

}  // namespace lichtraum
