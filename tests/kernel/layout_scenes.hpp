#pragma once

#include <memory>
#include <vector>

#include "primitives.hpp"
#include "scene/device_conversion.hpp"
#include "scene/flat_scene.hpp"

/// Scenes and rays for tests that compare layouts.
namespace lichtraum::test {

constexpr std::size_t packet_size = 64;

/// Rays in packets of one origin each.
struct Rays {
  std::vector<float4> origins, directions;
  void add_packet(Vec3 const& origin, auto&& direction) {
    for (std::size_t i = 0; i < packet_size; ++i) {
      origins.push_back(to_float4(origin));
      directions.push_back(to_float4(direction(), 1));
    }
  }
  std::size_t size() const { return origins.size(); }
};

inline device::TrianglePrimitive tagged_triangle(Vec3 const& a, Vec3 const& b, Vec3 const& c, device::uint shape) {
  device::TrianglePrimitive triangle = make_triangle(a, b, c);
  triangle.tag = {shape % 2, shape};
  return triangle;
}

inline void add_triangles(Random& random, std::size_t count, FlatObject& object) {
  for (std::size_t i = 0; i < count; ++i) {
    Vec3 const a = random.in_cube(3);
    Vec3 const b = a + random.in_cube(0.5);
    // Some degenerate: a point, a line, a flat one.
    Vec3 const c = i % 17 == 0 ? a : i % 19 == 0 ? 0.5 * (a + b) : a + random.in_cube(i % 23 == 0 ? 1e-6 : 0.5);
    object.triangles.push_back(tagged_triangle(a, b, c, device::uint(object.primitive_count())));
  }
}

inline Transform random_transform(Random& random, Vec3 const& offset) {
  Mat3 const m = random.rotation() * Mat3(random.uniform(0.3, 1.2), 0, 0, 0, random.uniform(0.3, 1.2), 0, 0, 0, 0.7);
  Mat4 matrix(m);
  matrix[3] = glm::dvec4(offset, 1);
  return Transform::from_matrix(matrix);
}

/// Scales from 1e-4 to 1e4, sheared, mirrored, flattened, and as far away as a million times their size.
inline std::vector<Transform> nasty_transforms() {
  Mat4 shear(1);
  shear[1][0] = 3;
  shear[2][1] = -2;
  Transform const sheared = Transform::from_matrix(shear);
  Transform const turned = Transform::rotation(37, Vec3(1, 2, 3));
  auto const moved = [](Vec3 const& offset, Transform const& t) { return Transform::translation(offset) * t; };
  return {turned * Transform::scaling(Vec3(1e-4)),
          turned * Transform::scaling(Vec3(1e4)),
          turned * Transform::scaling(Vec3(1, 1e-3, 20)),
          turned * sheared,
          Transform::scaling(Vec3(-1, 1, 1)) * turned,
          moved(Vec3(1e6, -3e5, 2e5), turned),
          moved(Vec3(70, 1, -100), turned * Transform::scaling(Vec3(1e-4))),
          moved(Vec3(1e9, 0, 1e8), sheared * Transform::scaling(Vec3(-1e4, 1e4, 1e4)))};
}

inline device::SpherePrimitive tagged_sphere(Vec3 const& center, double radius, device::PrimitiveTag const& tag) {
  device::SpherePrimitive sphere = make_sphere(center, radius);
  sphere.tag = tag;
  return sphere;
}

template <class UnitPrimitive>
UnitPrimitive unit_shape(Random& random, device::PrimitiveTag const& tag) {
  UnitPrimitive shape{};
  shape.unit_from_object = device_transform(random_transform(random, random.in_cube(3)).inverse());
  shape.tag = tag;
  return shape;
}

/// Every kind of primitive, half of them of glass, overlapping, and a cluster of spheres only; and instances of half of
/// them.
inline FlatScene mixed_scene(std::uint64_t seed) {
  Random random(seed);
  FlatScene scene;
  scene.objects.resize(2);
  for (FlatObject& object : scene.objects) {
    add_triangles(random, 400, object);
    for (int i = 0; i < 40; ++i) {
      auto const tag = [&] {
        return device::PrimitiveTag{device::uint(i % 2), device::uint(object.primitive_count())};
      };
      Vec3 const center = random.in_cube(3);
      object.spheres.push_back(tagged_sphere(center, random.uniform(0.05, 0.4), tag()));
      object.ellipsoids.push_back(unit_shape<device::EllipsoidPrimitive>(random, tag()));
      object.cylinders.push_back(unit_shape<device::CylinderPrimitive>(random, tag()));
      object.cones.push_back(unit_shape<device::ConePrimitive>(random, tag()));
      device::BoxPrimitive box{};
      box.box_from_object = device_transform(random_transform(random, random.in_cube(3)).inverse());
      for (int axis = 0; axis < 3; ++axis) {
        box.min[axis] = float(random.uniform(-0.4, 0));
        box.max[axis] = i % 5 == axis ? box.min[axis] : float(random.uniform(0, 0.4));  // some flat
      }
      box.tag = tag();
      object.boxes.push_back(box);
    }
    for (int i = 0; i < 100; ++i) {
      device::PrimitiveTag const tag{device::uint(i % 2), device::uint(object.primitive_count())};
      object.spheres.push_back(tagged_sphere(Vec3(3) + random.in_cube(1), random.uniform(0.05, 0.2), tag));
    }
  }
  for (int i = 0; i < 12; ++i) scene.instances.push_back({1, random_transform(random, random.in_cube(8))});
  // Planes of glass, in the world and in an instance among other things.
  scene.objects.resize(3);
  for (FlatObject* const object : {&scene.objects[0], &scene.objects[2]}) {
    for (device::uint i = 0; i < 9; ++i) {
      object->cones.push_back(
          unit_shape<device::ConePrimitive>(random, {i % 2, device::uint(object->primitive_count())}));
    }
    object->planes.push_back(unit_shape<device::PlanePrimitive>(random, {1, device::uint(object->primitive_count())}));
  }
  scene.instances.push_back({2, random_transform(random, random.in_cube(8))});
  auto const glass = std::make_shared<Material>("glass", PhongModel{.transmit = 0.5, .ior = 1.5});
  scene.materials = {std::make_shared<Material>(), glass};
  return scene;
}

/// Narrow packets from outside, wide ones from inside, some along axes and some within planes of them.
inline Rays mixed_rays(std::uint64_t seed, std::size_t packets) {
  Random random(seed);
  Rays rays;
  for (std::size_t i = 0; i < packets; ++i) {
    bool const outside = i % 2 == 0;
    Vec3 const origin = outside ? random.direction() * 20. : random.in_cube(3);
    Vec3 const center = random.in_cube(3) - origin;
    double const spread = outside ? 0.5 : 8;
    rays.add_packet(origin, [&] {
      Vec3 d = center + random.in_cube(spread);
      for (int axis = 0; axis < 3; ++axis) {
        if (i % 11 == std::size_t(axis) || i % 13 == std::size_t(axis)) d[axis] = 0;
      }
      return d;
    });
  }
  return rays;
}

}  // namespace lichtraum::test
