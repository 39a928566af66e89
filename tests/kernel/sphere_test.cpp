#include "shape_probe.hpp"
#include "support/catch.hpp"
#include "support/skip.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

namespace {

device::SpherePrimitive sphere(Vec3 const& center, double radius) {
  return {{float(center.x), float(center.y), float(center.z)}, float(radius), {0, 0}};
}

/// How far the hit lies off the sphere may only be roundings of the numbers involved.
bool lies_on_sphere(ProbeRay const& ray, double t, Vec3 const& center, double radius) {
  double const off = std::abs(glm::length(ray.at(t) - center) - radius);
  double const numbers = radius + glm::length(to_vec3(ray.origin) - center);
  return off <= 8 * rounding_unit * numbers;
}

}  // namespace

TEST_CASE("Sphere hits are the reference's at every scale", "[kernel]") {
  NEEDS_OPENCL_DEVICE();
  Random random(10);
  ShapeCases<device::SpherePrimitive> cases;
  std::size_t const count = scaled_count(100000);
  for (std::size_t i = 0; i < count; ++i) {
    double const scale = std::array{1e-3, 1., 1e6}[i % 3];
    Vec3 const center = random.in_cube(10 * scale);
    double const radius = scale * random.uniform(0.1, 1);
    auto const [origin, direction] = random_ray(random, center, radius);
    cases.add(sphere(center, radius), origin, direction);
  }
  auto const t = cases.run("probe_sphere");
  std::size_t hits = 0, grazing = 0;
  for (std::size_t i = 0; i < count; ++i) {
    Vec3 const center = to_vec3(cases.primitives[i].center);
    double const radius = cases.primitives[i].radius;
    ProbeRay const& ray = cases.rays[i];
    Vec3 const o = to_vec3(ray.origin), d = to_vec3(ray.direction);
    auto const crossing = cross_sphere(center, radius, o, d);
    double const expected = nearest_in_front(crossing);
    bool const hit = t[i] < float_infinity;
    hits += hit;
    // Where the line passes the sphere's edge within a few roundings, either answer is right.
    double const slack = 8 * rounding_unit * (1 + glm::length(o - center) / radius);
    INFO(i << ": t " << t[i] << ", reference " << expected << ", margin " << crossing.margin);
    if (std::abs(crossing.margin) < slack) {
      ++grazing;
    } else if (hit != (expected < infinity)) {
      FAIL("hit or miss");
    } else if (hit && std::abs(t[i] - expected) * glm::length(d) >
                          8 * rounding_unit * (radius + glm::length(o - center)) / std::sqrt(crossing.margin)) {
      FAIL("distance");  // the square root: a line that passes the edge closely meets the sphere at a small angle
    }
    if (hit && !lies_on_sphere(ray, t[i], center, radius)) FAIL("not on the sphere");
  }
  CHECK(hits > count / 4);
  CHECK(hits < count * 3 / 4);
  CHECK(grazing <= 1 + count / 200);
}

TEST_CASE("Sphere edge cases", "[kernel]") {
  NEEDS_OPENCL_DEVICE();
  ShapeCases<device::SpherePrimitive> cases;
  std::vector<float> expected;
  auto const add = [&](Vec3 const& center, double radius, Vec3 const& o, Vec3 const& d, float limit, double t) {
    cases.add(sphere(center, radius), o, d, limit);
    expected.push_back(float(t));
  };
  float const inf = float_infinity, nan = float_nan;
  Vec3 const c{0, 0, 0}, z{0, 0, 1};
  add(c, 1, {0, 0, -3}, z, inf, 2);
  add(c, 1, {0, 0, -3}, 4. * z, inf, 0.5);                // any length of direction
  add(c, 1, {0, 0, 0}, z, inf, 1);                        // from the centre
  add(c, 1, {0, 0.5, 0}, {0, 1, 0}, inf, 0.5);            // from inside
  add(c, 1, {0, 0, 3}, z, inf, inf);                      // behind
  add(c, 1, {1, 0, -3}, z, inf, 3);                       // touching exactly
  add(c, 1, {1.000001, 0, -3}, z, inf, inf);              // just past
  add(c, 1, {0, 0, -3}, z, 2, inf);                       // t_max is exclusive
  add(c, 1, {0, 0, -3}, z, 2.000001f, 2);                 //
  add(c, 1, {0, 0, -1}, z, inf, 2);                       // from the surface inwards: t = 0 does not count
  add(c, 1, {0, 0, 1}, z, inf, inf);                      // from the surface outwards
  add(c, 1, {0, 0, 1}, {1, 0, 0}, inf, inf);              // from the surface along it
  add({0, 0, 1e6}, 1e-3, {0, 0, 0}, z, inf, 1e6);         // tiny and far
  add({0, -1e6, 0}, 1e6, {0, 1, 0}, {0, -1, 0}, inf, 1);  // a planet under the feet
  add(c, 1e6, {0, 0, -2e6}, z, inf, 1e6);                 // huge
  add(c, 1e-3, {0, 0, -2e-3}, z, inf, 1e-3);              // tiny
  add({nan, 0, 0}, 1, {0, 0, -3}, z, inf, inf);
  add(c, nan, {0, 0, -3}, z, inf, inf);
  add(c, 1, {nan, 0, -3}, z, inf, inf);
  add(c, 1, {0, 0, -3}, {0, 0, nan}, inf, inf);
  add(c, 1, {0, 0, -3}, {0, 0, 0}, inf, inf);  // no direction
  auto const t = cases.run("probe_sphere");
  for (std::size_t i = 0; i < t.size(); ++i) {
    INFO("case " << i);
    if (expected[i] == inf)
      CHECK(t[i] == inf);
    else
      CHECK(t[i] == Approx(expected[i]).epsilon(1e-6));
  }
}

TEST_CASE("Ellipsoid hits are the reference's under any affine map", "[kernel]") {
  NEEDS_OPENCL_DEVICE();
  Random random(11);
  ShapeCases<device::EllipsoidPrimitive> cases;
  std::vector<double> sizes;
  std::size_t const count = scaled_count(60000);
  for (std::size_t i = 0; i < count; ++i) {
    double const scale = std::array{1e-3, 1., 1e6}[i % 3];
    Vec3 const factors = scale * Vec3(random.uniform(0.1, 1), random.uniform(0.1, 1), -random.uniform(0.1, 1));
    Mat3 const stretch(factors.x, 0, 0, 0, factors.y, 0, 0, 0, factors.z);
    Affine const object_from_unit{random.rotation() * stretch * random.rotation(), random.in_cube(5 * scale)};
    auto const [origin, direction] = random_ray(random, object_from_unit.offset, max_abs(factors));
    cases.add({to_device(object_from_unit.inverse()), {0, 0}, {0, 0}}, origin, direction);
  }
  auto const t = cases.run("probe_ellipsoid");
  std::size_t hits = 0, unclear = 0;
  for (std::size_t i = 0; i < count; ++i) {
    Affine const unit_from_object = from_device(cases.primitives[i].unit_from_object);
    Vec3 const o = unit_from_object.point(to_vec3(cases.rays[i].origin));
    Vec3 const d = unit_from_object.linear * to_vec3(cases.rays[i].direction);
    auto const crossing = cross_sphere(Vec3(0), 1, o, d);
    double const expected = nearest_in_front(crossing);
    bool const hit = t[i] < float_infinity;
    hits += hit;
    // In the unit sphere's frame, the mapped ray's coordinates carry roundings of all terms of the map.
    double const terms = 1 + max_abs(unit_from_object.offset) + 3 * glm::length(o);
    double const slack = 16 * rounding_unit * terms;
    INFO(i << ": t " << t[i] << ", reference " << expected << ", margin " << crossing.margin);
    if (std::abs(crossing.margin) < slack) {
      ++unclear;
    } else if (hit != (expected < infinity)) {
      FAIL("hit or miss");
    } else if (hit && std::abs(t[i] - expected) * glm::length(d) > slack / std::sqrt(crossing.margin)) {
      FAIL("distance");
    }
  }
  CHECK(hits > count / 5);
  CHECK(unclear <= 1 + count / 50);
}

TEST_CASE("Surfaces in front of the origin and before t_max are counted once each", "[kernel]") {
  NEEDS_OPENCL_DEVICE();
  struct Ends {
    float enter, leave;
  };
  float const inf = float_infinity;
  std::vector<Ends> const ends{{1, 2}, {1, 2}, {1, 2}, {-1, 2}, {-2, -1}, {1, 1}, {0, 1}, {inf, inf}, {-1, 0}, {1, 2}};
  std::vector<float> const t_max{inf, 1.5f, 0.5f, inf, inf, inf, inf, inf, inf, 2};
  std::vector<device::uint> counts(ends.size());
  ProbeProgram("shapes.cl").run("probe_count_in_front", ends.size(), {in(ends), in(t_max), out(counts)});
  CHECK(counts == std::vector<device::uint>{2, 1, 0, 1, 0, 1, 1, 0, 0, 1});
}
