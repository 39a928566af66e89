#include "random_scene.hpp"
#include "scene/device_light.hpp"
#include "support/catch.hpp"
#include "support/skip.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

namespace {

enum class SurfaceKind { triangle, sphere, ellipsoid, box, flat_box, cylinder, cone, plane };

/// A unit shape's map, with its middle at `at`.
Affine upright(Random& random, double scale, Vec3 const& at) {
  Mat3 const linear = random_affine(random, scale, 0).linear;
  return {linear, at - linear * Vec3(0, 0.5, 0)};
}

/// Of several faces, how far one is away and its normal: the nearest counts. `off` begins as 0 with a normal of 0.
void take_nearest(double face_off, Vec3 const& face_normal, double& off, Vec3& normal) {
  if (normal != Vec3(0) && std::abs(face_off) >= std::abs(off)) return;
  off = face_off;
  normal = face_normal;
}

/// One convex shape in front of a great many rays, in the world or in an instance, with its true surface in double.
struct OneShape {
  SceneArrays scene;
  Affine shape_from_world;  // into the shape's own frame: the triangle's and sphere's object, the unit sphere, the box
  SurfaceKind kind;
  Vec3 center;  // world
  double size;

  OneShape(SurfaceKind k, double scale, Vec3 const& place, bool instanced, Random& random)
      : kind(k), center(place), size(scale) {
    Affine const world_from_object =
        instanced ? Affine{random.rotation() * Mat3(0.5, 0, 0, 0, 2, 0, 0, 0, -1) * random.rotation(), place}
                  : Affine{};
    // In an instance the shape sits at a distance from the object's origin, too.
    Vec3 const at = instanced ? random.in_cube(2 * scale) : place;
    Affine frame;
    if (k == SurfaceKind::triangle) {
      scene.add(make_triangle(at + random.in_cube(scale), at + random.in_cube(scale), at + random.in_cube(scale)));
    } else if (k == SurfaceKind::sphere) {
      scene.add(make_sphere(at, scale));
    } else if (k == SurfaceKind::ellipsoid) {
      scene.add(make_ellipsoid({random_affine(random, scale, 0).linear, at}));
      frame = from_device(scene.ellipsoids[0].unit_from_object);
    } else if (k == SurfaceKind::cylinder) {
      scene.add(make_unit_shape<device::CylinderPrimitive>(upright(random, scale, at)));
      frame = from_device(scene.cylinders[0].unit_from_object);
    } else if (k == SurfaceKind::cone) {
      scene.add(make_unit_shape<device::ConePrimitive>(upright(random, scale, at)));
      frame = from_device(scene.cones[0].unit_from_object);
    } else if (k == SurfaceKind::plane) {
      scene.add(make_unit_shape<device::PlanePrimitive>({random_affine(random, scale, 0).linear, at}));
      frame = from_device(scene.planes[0].unit_from_object);
    } else {
      Vec3 const corner = scale * Vec3(0.7, 0.4, k == SurfaceKind::flat_box ? 0 : 0.9);
      scene.add(make_box({random.rotation(), at}, -corner, corner));
      frame = from_device(scene.boxes[0].box_from_object);
    }
    auto const [object, bounds] = scene.close_object();
    Affine object_from_world;
    if (instanced) {
      scene.add_instance(world_from_object, object, bounds);
      scene.close_object();
      object_from_world = from_device(scene.instances[0].object_from_world);
      center = world_from_object.point(at);
    }
    shape_from_world = {frame.linear * object_from_world.linear, frame.point(object_from_world.offset)};
  }

  /// How far along the normal a world point lies off the shape's surface (to first order), and the true normal there.
  std::pair<double, Vec3> distance_and_normal(Vec3 const& world) const {
    Vec3 const p = shape_from_world.point(world);
    double off = 0;
    Vec3 normal(0);
    if (kind == SurfaceKind::triangle) {
      auto const& t = scene.triangles[0];
      Vec3 const a = to_vec3(t.vertices[0]);
      normal = glm::normalize(glm::cross(to_vec3(t.vertices[1]) - a, to_vec3(t.vertices[2]) - a));
      off = glm::dot(normal, p - a);
    } else if (kind == SurfaceKind::sphere || kind == SurfaceKind::ellipsoid) {
      bool const unit = kind == SurfaceKind::ellipsoid;
      Vec3 const from_center = p - (unit ? Vec3(0) : to_vec3(scene.spheres[0].center));
      off = glm::length(from_center) - (unit ? 1. : double(scene.spheres[0].radius));
      normal = glm::normalize(from_center);
    } else if (kind == SurfaceKind::cylinder) {
      Vec3 const across(p.x, 0, p.z);
      take_nearest(glm::length(across) - 1, glm::normalize(across), off, normal);
      take_nearest(-p.y, {0, -1, 0}, off, normal);
      take_nearest(p.y - 1, {0, 1, 0}, off, normal);
    } else if (kind == SurfaceKind::cone) {
      Vec3 const across(p.x, 0, p.z);
      take_nearest((glm::length(across) - (1 - p.y)) / std::sqrt(2.),
                   glm::normalize(glm::normalize(across) + Vec3(0, 1, 0)), off, normal);
      take_nearest(-p.y, {0, -1, 0}, off, normal);
    } else if (kind == SurfaceKind::plane) {
      off = p.y;
      normal = {0, 1, 0};
    } else {
      off = infinity;
      for (int axis = 0; axis < 3; ++axis) {
        for (int side = 0; side < 2; ++side) {
          double const d = side == 0 ? scene.boxes[0].min[axis] - p[axis] : p[axis] - scene.boxes[0].max[axis];
          if (std::abs(d) < std::abs(off)) {
            off = d;
            normal = Vec3(0);
            normal[axis] = side == 0 ? -1 : 1;
          }
        }
      }
    }
    Vec3 const world_normal = glm::transpose(shape_from_world.linear) * normal;
    return {off / glm::length(world_normal), glm::normalize(world_normal)};
  }
};

}  // namespace

// Acne is a ray that hits what it has just left; a leak is a ray that starts beyond what it should have hit.
TEST_CASE("Points lie on the surface within their offset, and rays that leave it get away", "[kernel]") {
  NEEDS_OPENCL_DEVICE();
  Random usual(60), rare(61);
  ProbeProgram const program("surface.cl");
  std::size_t const count = scaled_count(4000);
  for (double const scale : {1e-3, 1., 1e3, 1e6}) {
    for (double const far : {0., 1., 100.}) {
      for (bool const instanced : {false, true}) {
        for (SurfaceKind const kind :
             {SurfaceKind::triangle, SurfaceKind::sphere, SurfaceKind::ellipsoid, SurfaceKind::box,
              SurfaceKind::flat_box, SurfaceKind::cylinder, SurfaceKind::cone, SurfaceKind::plane}) {
          Random& random = kind < SurfaceKind::cylinder ? usual : rare;
          OneShape const shape(kind, scale, random.in_cube(far * scale), instanced, random);
          std::vector<ProbeRay> rays(count);
          for (std::size_t i = 0; i < count; ++i) {
            // From near, from inside and from far away.
            double const distance = std::array{3., 0.1, 1000.}[i % 3] * scale;
            Vec3 const origin = shape.center + random.direction() * distance;
            rays[i].origin = to_float4(origin);
            rays[i].direction = to_float4(glm::normalize(shape.center + random.in_cube(0.7 * scale) - origin));
          }
          std::vector<ProbeHit> hits(count), next(count), crossing(count);
          std::vector<float4> positions(count), normals(count), outward(count), inward(count);
          program.run("probe_find_surface", count,
                      shape.scene.arguments({in(rays), out(hits), out(positions), out(normals)}));
          std::size_t found = 0;
          double worst = 0, largest_offset = 0;
          for (std::size_t i = 0; i < count; ++i) {
            outward[i] = inward[i] = {0, 0, 1, 0};
            if (hits[i].kind == none) continue;
            ++found;
            Vec3 const p = to_vec3(positions[i]), n = to_vec3(normals[i]);
            auto const [off, normal] = shape.distance_and_normal(p);
            double const offset = positions[i].w;
            worst = std::max(worst, std::abs(off) / offset);
            largest_offset = std::max(largest_offset, offset);
            // Two faces are equally near at an edge.
            bool const edge = kind == SurfaceKind::box || kind == SurfaceKind::flat_box ||
                              kind == SurfaceKind::cylinder || kind == SurfaceKind::cone;
            if (!edge && glm::length(n - normal) > 1e-3 && glm::length(n + normal) > 1e-3) FAIL("normal");
            if (std::abs(glm::length(n) - 1) > 1e-6) FAIL("length of the normal");
            Vec3 d = random.direction();
            if (glm::dot(d, n) < 0) d = -d;
            if (i % 4 == 0) d = glm::normalize(d - (glm::dot(d, n) - 1e-3) * n);  // nearly along the surface
            outward[i] = to_float4(d);
            inward[i] = to_float4(-d);
          }
          program.run("probe_leave_surface", count,
                      shape.scene.arguments({in(positions), in(normals), in(outward), out(next)}));
          program.run("probe_leave_surface", count,
                      shape.scene.arguments({in(positions), in(normals), in(inward), out(crossing)}));
          std::size_t acne = 0, leaks = 0;
          for (std::size_t i = 0; i < count; ++i) {
            if (hits[i].kind == none) continue;
            // All shapes are convex: nothing is outside; inside there is the other side, except of what is flat.
            acne += next[i].kind != none;
            bool const solid =
                kind != SurfaceKind::triangle && kind != SurfaceKind::flat_box && kind != SurfaceKind::plane;
            if (solid && i % 4 != 0) leaks += crossing[i].kind == none;
            if (!solid) acne += crossing[i].kind != none;
          }
          INFO("kind " << int(kind) << " scale " << scale << " away " << far << " instance " << instanced << " hits "
                       << found << " worst " << worst << " largest offset " << largest_offset);
          CHECK(worst < 0.5);  // the other half is for what the next ray's own arithmetic rounds
          CHECK(acne == 0);
          CHECK(leaks <= found / 1000);
          // Points of a plane may be far away, where numbers are larger.
          if (kind != SurfaceKind::plane) CHECK(largest_offset < 2e-4 * scale * (1 + far));
          if (count >= 1000) CHECK(found > count / 100);  // some triangles are slivers
        }
      }
    }
  }
}

TEST_CASE("A light is visible unless something opaque lies strictly before it", "[kernel]") {
  NEEDS_OPENCL_DEVICE();
  SceneArrays scene;
  for (float const transmit : {0.f, 0.5f}) {
    device::PhongMaterial material{};
    material.transmit = transmit;
    scene.materials.push_back(material);
  }
  scene.add(make_triangle({-9, 0, -9}, {9, 0, -9}, {0, 0, 18}));      // the floor
  scene.add(make_sphere({0, 2, 0}, 1));                               // opaque
  scene.add(make_sphere({4, 2, 0}, 1, 1));                            // glass: two surfaces
  scene.add(make_triangle({-5, 2, -1}, {-3, 2, -1}, {-4, 2, 1}, 1));  // glass: one
  scene.close_object();
  struct Case {
    Vec3 point, light;
    double visibility;
  };
  double const glass = 0.5;
  std::vector<Case> const cases{
      {{0, 0, 0}, {0, 5, 0}, 0},              // the sphere between
      {{0, 0, 0}, {0, 0.9, 0}, 1},            // the light before the sphere
      {{0, 0, 0}, {0, 2, 0}, 0},              // the light inside of it
      {{0, 0, 0}, {0, 1, 0}, 1},              // the light on it: not strictly before
      {{2, 0, 0}, {2, 5, 0}, 1},              // past both
      {{4, 0, 0}, {4, 5, 0}, glass * glass},  // through glass
      {{4, 0, 0}, {4, 2, 0}, glass},          // the light inside of glass
      {{-4, 0, 0}, {-4, 5, 0}, glass},        // a pane
      {{-4, 0, 0}, {-4, 2, 0}, 1},            // the light on the pane
      {{2, 0, 0}, {2, -5, 0}, 0},             // below the floor
      {{2, 0, 0}, {2e6, 5e6, 0}, 1},          // a sun
      {{0, 0, 0}, {0, 5e6, 0}, 0},            //
      {{2, 0, 0}, {2.001, 1e-3, 0}, 1},       // just above the floor
  };
  std::vector<float4> positions, normals;
  std::vector<device::PunctualLight> lights;
  for (auto const& c : cases) {
    positions.push_back(to_float4(c.point, 1e-5));
    normals.push_back({0, 1, 0, 0});
    lights.push_back(*device_light(Light::point("", c.light, Rgb(1))));
  }
  std::vector<float> visibility(cases.size());
  ProbeProgram("surface.cl")
      .run("probe_light_visibility", cases.size(),
           scene.arguments({in(positions), in(normals), in(lights), out(visibility)}));
  for (std::size_t i = 0; i < cases.size(); ++i) {
    INFO("case " << i);
    CHECK(visibility[i] == float(cases[i].visibility));
  }
}
