#include "compile/emissive_shapes.hpp"

#include <algorithm>
#include <tuple>

#include "accel/primitive_bounds.hpp"
#include "compile/light_choice.hpp"
#include "scene/device_conversion.hpp"

namespace lichtraum {
namespace {

/// Of each list. More are found by chance only: they would take more memory than the scene.
constexpr std::size_t most_emissive = std::size_t(1) << 20;

constexpr device::uint no_instance = 0xffffffffu;  // as the kernels' NO_INSTANCE

/// Calls f(index, corners, material) for each triangle of an object, with its index among all.
template <class F>
void for_each_triangle(SceneBuffers const& scene, CompiledObject const& object, F const& f) {
  if (scene.layout == TreeLayout::binary) {
    for (auto const& reference : std::span(scene.references).subspan(object.first_leaf, object.leaf_count)) {
      if (reference.kind != PRIMITIVE_TRIANGLE) continue;
      auto const& [vertices, tag] = scene.triangles[reference.index];
      f(
          reference.index, [&v = vertices](int corner) { return Vec3(v[corner][0], v[corner][1], v[corner][2]); },
          tag.material);
    }
    return;
  }
  std::size_t const end = BLOCK_LANES * (std::size_t(object.first_leaf) + object.leaf_count);
  for (std::size_t i = BLOCK_LANES * std::size_t(object.first_leaf); i < end; ++i) {
    auto const& v = scene.triangle_blocks[i / BLOCK_LANES].vertices;
    std::size_t const lane = i % BLOCK_LANES;
    if (!(v[0][0][lane] == v[0][0][lane])) continue;  // there is none
    f(
        device::uint(i), [&](int corner) { return Vec3(v[corner][0][lane], v[corner][1][lane], v[corner][2][lane]); },
        scene.triangle_tags[i].material);
  }
}

/// Calls f(index, center, radius, material) for each sphere.
template <class F>
void for_each_sphere(SceneBuffers const& scene, CompiledObject const& object, F const& f) {
  if (scene.layout == TreeLayout::binary) {
    for (auto const& reference : std::span(scene.references).subspan(object.first_leaf, object.leaf_count)) {
      if (reference.kind != PRIMITIVE_SPHERE) continue;
      auto const& [c, radius, tag] = scene.spheres[reference.index];
      f(reference.index, Vec3(c[0], c[1], c[2]), double(radius), tag.material);
    }
    return;
  }
  std::size_t const first = BLOCK_LANES * std::size_t(object.first_sphere_block);
  for (std::size_t i = first; i < first + BLOCK_LANES * std::size_t(object.sphere_block_count); ++i) {
    auto const& [c, radius, tags] = scene.sphere_blocks[i / BLOCK_LANES];
    std::size_t const lane = i % BLOCK_LANES;
    if (!(radius[lane] == radius[lane])) continue;  // there is none
    f(device::uint(i), Vec3(c[0][lane], c[1][lane], c[2][lane]), double(radius[lane]), tags[lane].material);
  }
}

/// The middle of a box in a frame of its own, and half its edges, which may be 0.
struct HalfBox {
  Vec3 center;
  Vec3 extent;
};
HalfBox half_box(device::BoxPrimitive const& box) {
  Vec3 const min(box.min[0], box.min[1], box.min[2]), max(box.max[0], box.max[1], box.max[2]);
  return {0.5 * (min + max), 0.5 * (max - min)};
}

/// Whether no light goes through: what does has two surfaces along a direction that shine.
bool is_opaque(device::ShadingArrays const& tables, std::size_t material) {
  if (material < tables.pbr_materials.size()) {
    device::PbrMaterial const& pbr = tables.pbr_materials[material];
    if ((pbr.flags & PBR_IS_PRESENT) != 0) {
      return pbr.alpha_mode == ALPHA_OPAQUE && pbr.transmission == 0 && pbr.diffuse_transmission == 0;
    }
  }
  return tables.materials[material].transmit == 0;
}

class Finder {
 public:
  explicit Finder(SceneBuffers& scene) : scene_(scene), shines_(emissive_materials(scene.shading)) {
    for (std::size_t i = 0; i < shines_.size(); ++i) is_lamp_.push_back(shines_[i] && is_opaque(scene.shading, i));
  }

  bool has_any() const { return std::ranges::find(shines_, true) != shines_.end(); }

  /// Of one object, in one place. `instance`: the device's number.
  void add(CompiledObject const& object, Transform const& world_from_object, device::uint instance) {
    for_each_triangle(scene_, object, [&](device::uint index, auto const& corner, device::uint material) {
      if (!shines_[material] || scene_.emissive_triangles.size() > most_emissive) return;
      Vec3 const a = world_from_object.point(corner(0));
      device::EmissiveTriangle emissive{};
      store(a, emissive.corner);
      for (int edge = 0; edge < 2; ++edge) {
        store(world_from_object.point(corner(edge + 1)) - a, emissive.edges[edge]);
      }
      emissive.triangle = index;
      emissive.material = material;
      scene_.emissive_triangles.push_back(emissive);
    });
    for_each_sphere(scene_, object, [&](device::uint index, Vec3 const& center, double radius, device::uint material) {
      if (!is_lamp_[material]) return;
      Transform const object_from_unit = Transform::translation(center) * Transform::scaling(Vec3(radius));
      add_ball(world_from_object * object_from_unit, {instance, PRIMITIVE_SPHERE, index, material});
    });
    auto const& ellipsoids = object.ranges[PRIMITIVE_ELLIPSOID];
    for (std::size_t i = ellipsoids.first; i < ellipsoids.first + ellipsoids.count; ++i) {
      auto const& [unit_from_object, tag, padding] = scene_.ellipsoids[i];
      if (!is_lamp_[tag.material] || !bounds_of(scene_.ellipsoids[i]).is_finite()) continue;
      add_ball(world_from_object * host_transform(unit_from_object).inverse(),
               {instance, PRIMITIVE_ELLIPSOID, device::uint(i), tag.material});
    }
    auto const& boxes = object.ranges[PRIMITIVE_BOX];
    for (std::size_t i = boxes.first; i < boxes.first + boxes.count; ++i) {
      device::BoxPrimitive const& box = scene_.boxes[i];
      if (!is_lamp_[box.tag.material] || !bounds_of(box).is_finite()) continue;
      Transform const world_from_box = world_from_object * host_transform(box.box_from_object).inverse();
      HalfBox const half = half_box(box);
      Mat3 axes(0);
      for (int axis = 0; axis < 3; ++axis) {
        Vec3 edge(0);
        edge[axis] = half.extent[axis];
        axes[axis] = world_from_box.vector(edge);
      }
      add_solid({}, world_from_box.point(half.center), axes,
                {instance, PRIMITIVE_BOX, device::uint(i), box.tag.material});
    }
  }

  void finish() {
    if (scene_.emissive_triangles.size() > most_emissive) scene_.emissive_triangles = {};
    if (scene_.emissive_solids.size() > most_emissive) scene_.emissive_solids = {};
    // By what they are, as leaves of the hierarchy are in another order in each layout, and paths would find other
    // noise.
    std::ranges::sort(scene_.emissive_triangles, {}, [](device::EmissiveTriangle const& triangle) {
      auto const& [corner, edges, index, material] = triangle;
      return std::tuple(material, corner[0], corner[1], corner[2], edges[0][0], edges[0][1], edges[0][2], edges[1][0],
                        edges[1][1], edges[1][2]);
    });
    std::ranges::sort(scene_.emissive_solids, {}, [](device::EmissiveSolid const& solid) {
      return std::tuple(solid.instance, solid.kind, solid.index);
    });
  }

 private:
  /// What a hit says of it, and its material.
  struct Name {
    device::uint instance, kind, index, material;
  };

  void add_ball(Transform const& world_from_unit, Name const& name) {
    add_solid(device_transform(world_from_unit.inverse()), world_from_unit.point(Vec3(0)),
              Mat3(world_from_unit.matrix()), name);
  }

  void add_solid(device::AffineTransform const& unit_from_world, Vec3 const& center, Mat3 const& axes,
                 Name const& name) {
    device::EmissiveSolid solid{};
    solid.unit_from_world = unit_from_world;
    store(center, solid.center);
    for (int axis = 0; axis < 3; ++axis) store(axes[axis], solid.axes[axis]);
    solid.instance = name.instance;
    solid.kind = name.kind;
    solid.index = name.index;
    solid.material = name.material;
    if (scene_.emissive_solids.size() <= most_emissive) scene_.emissive_solids.push_back(solid);
  }

  SceneBuffers& scene_;
  std::vector<bool> shines_;   // materials
  std::vector<bool> is_lamp_;  // for solids
};

}  // namespace

void find_emissive_shapes(SceneBuffers& scene, std::vector<CompiledObject> const& objects, CompiledObject const& world,
                          std::span<FlatInstance const> instances) {
  Finder finder(scene);
  if (!finder.has_any()) return;
  finder.add(world, Transform(), no_instance);
  for (std::size_t i = 0; i < scene.flat_instances.size(); ++i) {
    FlatInstance const& instance = instances[scene.flat_instances[i]];
    // What is too large for the device is not drawn.
    if (!map_bounds(instance.world_from_object, objects[instance.object].bounds).is_finite()) continue;
    finder.add(objects[instance.object], instance.world_from_object, device::uint(i));
  }
  finder.finish();
}

}  // namespace lichtraum
