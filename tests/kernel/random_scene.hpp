#pragma once

#include <string>

#include "primitives.hpp"
#include "scene_arrays.hpp"

namespace lichtraum::test {

inline Affine random_affine(Random& random, double scale, double spread) {
  Mat3 const stretch(random.uniform(0.3, 1), 0, 0, 0, random.uniform(0.3, 1), 0, 0, 0, -random.uniform(0.3, 1));
  return {random.rotation() * stretch * random.rotation() * scale, random.in_cube(spread)};
}

/// `count` primitives of every kind, up to `size` large, within `spread` of the origin.
inline void add_random_primitives(SceneArrays& scene, Random& random, std::size_t count, double size, double spread,
                                  device::uint material_count) {
  for (std::size_t i = 0; i < count; ++i) {
    auto const material = device::uint(random.index(material_count));
    Vec3 const p = random.in_cube(spread);
    switch (random.index(4)) {
      case 0:
        scene.add(make_triangle(p, p + random.in_cube(size), p + random.in_cube(size), material));
        break;
      case 1:
        scene.add(make_sphere(p, size * random.uniform(0.1, 0.5), material));
        break;
      case 2:
        scene.add(make_ellipsoid(random_affine(random, size * 0.5, spread), material));
        break;
      default:
        scene.add(make_box(random_affine(random, 1, spread), Vec3(0), size * (0.6 + random.in_cube(0.4)), material));
    }
  }
}

/// All kinds, two levels: some primitives in the world and twenty instances of an object, mirrored and stretched.
inline SceneArrays make_random_scene(Random& random, double scale, std::vector<float> const& transmits) {
  SceneArrays scene;
  for (float transmit : transmits) {
    device::PhongMaterial material{};
    material.transmit = transmit;
    scene.materials.push_back(material);
  }
  auto const materials = device::uint(transmits.size());
  add_random_primitives(scene, random, 40, 0.5 * scale, scale, materials);
  auto const [object, bounds] = scene.close_object();
  add_random_primitives(scene, random, 200, 0.4 * scale, 4 * scale, materials);
  for (int i = 0; i < 20; ++i) scene.add_instance(random_affine(random, 0.7, 3 * scale), object, bounds);
  scene.close_object();
  return scene;
}

/// A crossing of one primitive, anywhere in the scene.
struct SceneCrossing {
  device::uint kind, index, instance, material;
  Crossing crossing;
};

/// Every primitive that the line meets or nearly meets, by testing all of them.
inline std::vector<SceneCrossing> cross_all(SceneArrays const& scene, ProbeRay const& ray) {
  std::vector<SceneCrossing> found;
  // Which primitives are in the object and which in the world follows from the trees.
  struct Level {
    device::uint root, instance;
    Vec3 o, d;
  };
  std::vector<Level> levels{{scene.root_node, none, to_vec3(ray.origin), to_vec3(ray.direction)}};
  for (std::size_t l = 0; l < levels.size(); ++l) {
    Level const level = levels[l];
    std::vector<device::uint> nodes{level.root};
    while (!nodes.empty()) {
      auto const& node = scene.nodes[nodes.back()];
      nodes.pop_back();
      for (auto const& child : node.children) {
        if (child.count == 0 && child.min[0] <= child.max[0]) nodes.push_back(child.first);
        for (device::uint i = 0; i < child.count; ++i) {
          auto const [kind, index] = scene.references[child.first + i];
          if (kind == PRIMITIVE_INSTANCE) {
            Affine const map = from_device(scene.instances[index].object_from_world);
            levels.push_back({scene.instances[index].root_node, index, map.point(level.o), map.linear * level.d});
            continue;
          }
          SceneCrossing c{kind, index, level.instance, 0, {}};
          if (kind == PRIMITIVE_TRIANGLE) {
            auto const& p = scene.triangles[index];
            c.material = p.tag.material;
            c.crossing = cross_triangle(to_vec3(p.vertices[0]), to_vec3(p.vertices[1]), to_vec3(p.vertices[2]), level.o,
                                        level.d);
          } else if (kind == PRIMITIVE_SPHERE) {
            auto const& p = scene.spheres[index];
            c.material = p.tag.material;
            c.crossing = cross_sphere(to_vec3(p.center), p.radius, level.o, level.d);
          } else if (kind == PRIMITIVE_ELLIPSOID) {
            auto const& p = scene.ellipsoids[index];
            Affine const map = from_device(p.unit_from_object);
            c.material = p.tag.material;
            c.crossing = cross_sphere(Vec3(0), 1, map.point(level.o), map.linear * level.d);
          } else {
            auto const& p = scene.boxes[index];
            Affine const map = from_device(p.box_from_object);
            c.material = p.tag.material;
            c.crossing = cross_box(to_vec3(p.min), to_vec3(p.max), map.point(level.o), map.linear * level.d);
          }
          if (c.crossing.margin > -1e-4) found.push_back(c);
        }
      }
    }
  }
  return found;
}

}  // namespace lichtraum::test
