#include "shape_probe.hpp"
#include "support/catch.hpp"
#include "support/skip.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

namespace {

device::BoxPrimitive box(Vec3 const& min, Vec3 const& max, Affine const& box_from_object = {}) {
  device::BoxPrimitive result{};
  result.box_from_object = to_device(box_from_object);
  for (int i = 0; i < 3; ++i) {
    result.min[i] = float(min[i]);
    result.max[i] = float(max[i]);
  }
  return result;
}

/// A box under a random map, and a ray about it.
device::BoxPrimitive add_random_box(ShapeCases<device::BoxPrimitive>& cases, Random& random, double scale,
                                    int flat_axis = -1) {
  Vec3 const min = random.in_cube(scale);
  Vec3 max = min + random.in_cube(scale) + 1.1 * scale;
  if (flat_axis >= 0) max[flat_axis] = min[flat_axis];
  Affine const object_from_box{random.rotation() * random.uniform(0.1, 3), random.in_cube(scale)};
  auto const [origin, direction] = random_ray(random, object_from_box.point(0.5 * (min + max)), scale);
  cases.add(box(min, max, object_from_box.inverse()), origin, direction);
  return cases.primitives.back();
}

/// The ray in the box's frame in double precision, and how far roundings of the map may move it there.
struct BoxRay {
  Vec3 o, d;
  double slack;
  BoxRay(device::BoxPrimitive const& primitive, ProbeRay const& ray) {
    Affine const box_from_object = from_device(primitive.box_from_object);
    o = box_from_object.point(to_vec3(ray.origin));
    d = box_from_object.linear * to_vec3(ray.direction);
    // A face met at a small angle multiplies them.
    double const slope = max_abs(d) / std::min({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
    slack = 16 * rounding_unit * slope *
            (3 * (glm::length(o) + max_abs(box_from_object.offset)) + max_abs(to_vec3(primitive.min)) +
             max_abs(to_vec3(primitive.max)));
  }
};

}  // namespace

TEST_CASE("Box hits are the reference's under any affine map", "[kernel]") {
  NEEDS_OPENCL_DEVICE();
  Random random(20);
  ShapeCases<device::BoxPrimitive> cases;
  std::size_t const count = scaled_count(100000);
  for (std::size_t i = 0; i < count; ++i) add_random_box(cases, random, std::array{1e-3, 1., 1e6}[i % 3]);
  auto const t = cases.run("probe_box");
  std::size_t hits = 0, unclear = 0;
  for (std::size_t i = 0; i < count; ++i) {
    BoxRay const ray(cases.primitives[i], cases.rays[i]);
    auto const crossing = cross_box(to_vec3(cases.primitives[i].min), to_vec3(cases.primitives[i].max), ray.o, ray.d);
    double const unit = max_abs(ray.d);
    double const expected = nearest_in_front(crossing);
    bool const hit = t[i] < float_infinity;
    hits += hit;
    INFO(i << ": t " << t[i] << ", reference " << expected);
    // Through an edge, or from on a face, within roundings: either answer is right.
    if (std::abs(crossing.t_leave - crossing.t_enter) * unit < ray.slack ||
        std::abs(crossing.t_enter) * unit < ray.slack || std::abs(crossing.t_leave) * unit < ray.slack) {
      ++unclear;
    } else if (hit != (expected < infinity)) {
      FAIL("hit or miss");
    } else if (hit && std::abs(t[i] - expected) * unit > ray.slack) {
      FAIL("distance");
    }
  }
  CHECK(hits > count / 5);
  CHECK(unclear <= 1 + count / 20);
}

TEST_CASE("Flat boxes are rectangles", "[kernel]") {
  NEEDS_OPENCL_DEVICE();
  Random random(21);
  ShapeCases<device::BoxPrimitive> cases;
  std::size_t const count = scaled_count(30000);
  for (std::size_t i = 0; i < count; ++i)
    add_random_box(cases, random, std::array{1e-3, 1., 1e6}[i % 3], int(i / 3 % 3));
  auto const t = cases.run("probe_box");
  std::size_t hits = 0, unclear = 0;
  for (std::size_t i = 0; i < count; ++i) {
    int const axis = int(i / 3 % 3);
    Vec3 const min = to_vec3(cases.primitives[i].min), max = to_vec3(cases.primitives[i].max);
    BoxRay const ray(cases.primitives[i], cases.rays[i]);
    double const expected = (min[axis] - ray.o[axis]) / ray.d[axis];
    Vec3 const p = ray.o + expected * ray.d;
    double margin = infinity;
    for (int k : {(axis + 1) % 3, (axis + 2) % 3}) margin = std::min({margin, p[k] - min[k], max[k] - p[k]});
    bool const hit = t[i] < float_infinity;
    hits += hit;
    INFO(i << ": t " << t[i] << ", reference " << expected << ", margin " << margin);
    if (std::abs(margin) < ray.slack || std::abs(expected) * max_abs(ray.d) < ray.slack) {
      ++unclear;
    } else if (hit != (margin > 0 && expected > 0)) {
      FAIL("hit or miss");
    } else if (hit && std::abs(t[i] - expected) * max_abs(ray.d) > ray.slack) {
      FAIL("distance");
    }
  }
  CHECK(hits > count / 10);
  CHECK(unclear <= 1 + count / 20);
}

TEST_CASE("Box edge cases", "[kernel]") {
  NEEDS_OPENCL_DEVICE();
  ShapeCases<device::BoxPrimitive> cases;
  std::vector<float> expected;
  auto const add = [&](device::BoxPrimitive const& b, Vec3 const& o, Vec3 const& d, float limit, double t) {
    cases.add(b, o, d, limit);
    expected.push_back(float(t));
  };
  float const inf = float_infinity, nan = float_nan;
  auto const cube = box(Vec3(-1), Vec3(1));
  auto const floor = box({-1, 0, -1}, {1, 0, 1});
  Vec3 const z{0, 0, 1};
  add(cube, {0, 0, -3}, z, inf, 2);
  add(cube, {0, 0, -3}, -z, inf, inf);            // behind
  add(cube, {0.3, 0.2, 0}, z, inf, 1);            // from inside: the far side
  add(cube, {1, 0, -3}, z, inf, 2);               // within a face's plane
  add(cube, {1, -1, -3}, {-0., -0., 1}, inf, 2);  // along an edge
  add(cube, {1.0000002, 0, -3}, z, inf, inf);     // parallel to a face, just off it
  add(cube, {0, 0, -1}, z, inf, 2);               // from on a face inwards
  add(cube, {0, 0, 1}, z, inf, inf);              // from on a face outwards
  add(cube, {0, 0, 1}, {1, 0, 0}, inf, 1);        // from on a face along it
  add(cube, {-3, -3, -3}, {1, 1, 1}, inf, 2);     // through two corners
  add(cube, {0, 0, -3}, z, 2, inf);               // t_max is exclusive
  add(cube, {0, 0, -3}, {0, 0, 0}, inf, inf);     // no direction
  add(cube, {0, 0, 0}, {0, 0, 0}, inf, inf);
  add(floor, {0, 1, 0}, {0, -2, 0}, inf, 0.5);
  add(floor, {0, -1, 0}, {0, 1, 0}, inf, 1);
  add(floor, {0, 0, 0}, {0, 1, 0}, inf, inf);  // from on it
  add(floor, {-3, 0, 0}, {1, 0, 0}, inf, 2);   // within its plane: its edge
  add(floor, {-3, 1e-6, 0}, {1, 0, 0}, inf, inf);
  add(box(Vec3(1e6), Vec3(2e6)), {1.5e6, 1.5e6, 0}, z, inf, 1e6);
  add(box(Vec3(-1e-3), Vec3(1e-3)), {0, 0, -2e-3}, z, inf, 1e-3);
  add(box({nan, -1, -1}, Vec3(1)), {0, 0, -3}, {0.01, 0.01, 1}, inf, inf);
  add(box(Vec3(-1), {1, 1, nan}), {0, 0, -3}, z, inf, inf);
  add(cube, {nan, 0, -3}, z, inf, inf);
  add(cube, {0, 0, -3}, {nan, 0, 1}, inf, inf);
  auto const t = cases.run("probe_box");
  for (std::size_t i = 0; i < t.size(); ++i) {
    INFO("case " << i);
    if (expected[i] == inf)
      CHECK(t[i] == inf);
    else
      CHECK(t[i] == Approx(expected[i]).epsilon(1e-6));
  }
}
