#include "shape_probe.hpp"
#include "support/catch.hpp"
#include "support/skip.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

namespace {

device::TrianglePrimitive triangle(Vec3 const& a, Vec3 const& b, Vec3 const& c) {
  device::TrianglePrimitive result{};
  for (int i = 0; i < 3; ++i) {
    result.vertices[0][i] = float(a[i]);
    result.vertices[1][i] = float(b[i]);
    result.vertices[2][i] = float(c[i]);
  }
  return result;
}

}  // namespace

TEST_CASE("Triangle hits are the reference's at every scale", "[kernel]") {
  NEEDS_OPENCL_DEVICE();
  Random random(30);
  ShapeCases<device::TrianglePrimitive> cases;
  std::size_t const count = scaled_count(100000);
  for (std::size_t i = 0; i < count; ++i) {
    double const scale = std::array{1e-3, 1., 1e6}[i % 3];
    Vec3 const a = random.in_cube(scale), b = random.in_cube(scale), c = random.in_cube(scale);
    auto [origin, direction] = random_ray(random, (a + b + c) / 3., 0.5 * scale);
    cases.add(triangle(a, b, c), origin, direction);
  }
  auto const t = cases.run("probe_triangle");
  std::size_t hits = 0, unclear = 0;
  for (std::size_t i = 0; i < count; ++i) {
    Vec3 const a = to_vec3(cases.primitives[i].vertices[0]), b = to_vec3(cases.primitives[i].vertices[1]),
               c = to_vec3(cases.primitives[i].vertices[2]);
    Vec3 const o = to_vec3(cases.rays[i].origin), d = to_vec3(cases.rays[i].direction);
    auto const crossing = cross_triangle(a, b, c, o, d);
    double const expected = nearest_in_front(crossing);
    bool const hit = t[i] < float_infinity;
    hits += hit;
    // Roundings are of the vertices' distances. The barycentric weights have them over the triangle's height as the ray
    // sees it, the distance over the sine of the angle at which the ray meets the plane.
    double const distance = std::max({glm::length(a - o), glm::length(b - o), glm::length(c - o)});
    Vec3 const normal = glm::cross(b - a, c - a);
    double const side = std::max({glm::length(b - a), glm::length(c - a), glm::length(b - c)});
    double const sine = std::abs(glm::dot(normal, d)) / (glm::length(normal) * glm::length(d));
    double const slack = 16 * rounding_unit * distance * side / (glm::length(normal) * sine);
    INFO(i << ": t " << t[i] << ", reference " << expected << ", margin " << crossing.margin << ", slack " << slack);
    if (std::abs(crossing.margin) < slack || std::abs(crossing.t_enter) * glm::length(d) < slack * side) {
      ++unclear;
    } else if (hit != (expected < infinity)) {
      FAIL("hit or miss");
    } else if (hit && std::abs(t[i] - expected) * glm::length(d) > slack * side) {
      FAIL("distance");
    }
  }
  CHECK(hits > count / 20);
  CHECK(unclear <= 1 + count / 20);
}

TEST_CASE("Triangle edge cases", "[kernel]") {
  NEEDS_OPENCL_DEVICE();
  ShapeCases<device::TrianglePrimitive> cases;
  std::vector<float> expected;
  auto const add = [&](device::TrianglePrimitive const& s, Vec3 const& o, Vec3 const& d, float limit, double t) {
    cases.add(s, o, d, limit);
    expected.push_back(float(t));
  };
  float const inf = float_infinity, nan = float_nan;
  Vec3 const a{0, 0, 0}, b{1, 0, 0}, c{0, 1, 0}, z{0, 0, 1}, inside{0.25, 0.25, -1};
  auto const front = triangle(a, b, c);
  add(front, inside, z, inf, 1);
  add(triangle(a, c, b), inside, z, inf, 1);  // the other side
  add(front, {0.25, 0.25, 2}, {0, 0, -4}, inf, 0.5);
  add(front, {0.25, 0.25, 1}, z, inf, inf);                               // behind
  add(front, {0.25, 0.25, 0}, z, inf, inf);                               // from on it
  add(front, inside, z, 1, inf);                                          // t_max is exclusive
  add(front, {0, 0, -1}, z, inf, 1);                                      // a vertex
  add(front, {0.5, 0.5, -1}, z, inf, 1);                                  // an edge
  add(front, {0.5, 0.50000006, -1}, z, inf, inf);                         // one ulp off an edge
  add(front, {-1e-30, 0.5, -1}, z, inf, inf);                             // next to nothing off an edge
  add(front, {-1, 0.25, 0}, {1, 0, 0}, inf, inf);                         // within its plane
  add(front, {-1, 0.25, 1e-3}, {1, 0, 0}, inf, inf);                      // parallel to it
  add(front, {0.25, -1, 0.25}, {0, 1, 0}, inf, inf);                      // parallel, the direction's zeros elsewhere
  add(triangle(a, b, b), inside, z, inf, inf);                            // degenerate: an edge,
  add(triangle(a, a, a), {0, 0, -1}, z, inf, inf);                        // a point,
  add(triangle(a, {0.25, 0.25, 0}, {0.5, 0.5, 0}), inside, z, inf, inf);  // collinear
  add(triangle({0, 0, 0}, {0.25, 0.25, 1}, {0.5, 0.5, 2}), {0.25, 0.25, -1}, z, inf, inf);
  add(triangle({nan, 0, 0}, b, c), inside, z, inf, inf);
  add(triangle(a, {1, nan, 0}, c), inside, z, inf, inf);
  add(triangle(a, b, {0, 1, nan}), inside, z, inf, inf);
  add(triangle(a, b, {0, inf, 0}), inside, z, inf, inf);
  add(front, {nan, 0.25, -1}, z, inf, inf);
  add(front, inside, {0, nan, 1}, inf, inf);
  add(front, inside, {0, 0, 0}, inf, inf);                                        // no direction
  add(triangle(1e6 * a, 1e6 * b, 1e6 * c), {2.5e5, 2.5e5, -1e-3}, z, inf, 1e-3);  // close above a huge floor
  add(triangle(1e-3 * a, 1e-3 * b, 1e-3 * c), {2.5e-4, 2.5e-4, -1e-3}, z, inf, 1e-3);
  // Rays that leave a floor of 1e6 from next to nothing above it, at small angles.
  auto const floor = triangle({-1e6, 0, -1e6}, {1e6, 0, -7e5}, {1e5, 0, 1e6});
  for (int k = 0; k < 20; ++k) add(floor, {300. * k, 1e-6, 77. * k}, {1, 0.1, 0.3 - 0.05 * k}, inf, inf);
  auto const t = cases.run("probe_triangle");
  for (std::size_t i = 0; i < t.size(); ++i) {
    INFO("case " << i);
    if (expected[i] == inf)
      CHECK(t[i] == inf);
    else
      CHECK(t[i] == Approx(expected[i]).epsilon(1e-6));
  }
}
