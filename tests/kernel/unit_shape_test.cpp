/// What is stored as a map to a shape of one size, against a body that shares no formula with it.

#include "random_scene.hpp"
#include "shape_probe.hpp"
#include "support/catch.hpp"
#include "support/convex_oracle.hpp"
#include "support/skip.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

namespace {

template <class Body>
void check_solid(std::string const& probe, std::uint64_t seed, Body const& body) {
  NEEDS_OPENCL_DEVICE();
  Random random(seed);
  ShapeCases<device::CylinderPrimitive> cases;
  std::size_t const count = scaled_count(20000);
  for (std::size_t i = 0; i < count; ++i) {
    double const scale = std::array{1e-3, 1., 1e6}[i % 3];
    Vec3 const factors = scale * Vec3(random.uniform(0.1, 1), random.uniform(0.1, 1), -random.uniform(0.1, 1));
    Mat3 const stretch(factors.x, 0, 0, 0, factors.y, 0, 0, 0, factors.z);
    Affine const object_from_unit{random.rotation() * stretch * random.rotation(), random.in_cube(5 * scale)};
    auto const [origin, direction] = random_ray(random, object_from_unit.point({0, 0.5, 0}), max_abs(factors));
    cases.add({{to_device(object_from_unit.inverse()), {}, {}}}, origin, direction);
  }
  auto const t = cases.run(probe);
  std::size_t hits = 0, unclear = 0;
  for (std::size_t i = 0; i < count; ++i) {
    Affine const unit_from_object = from_device(cases.primitives[i].unit_from_object);
    Ray const ray{unit_from_object.point(to_vec3(cases.rays[i].origin)),
                  unit_from_object.linear * to_vec3(cases.rays[i].direction)};
    ConvexCrossing const expected = cross_convex(ray, {0, 0.5, 0}, 2, body);
    auto const least = double(expected.least);
    bool const is_hit = t[i] < float_infinity;
    hits += is_hit;
    // In the unit frame, the mapped ray's coordinates carry roundings of all terms of the map.
    double const slack = 16 * rounding_unit * (1 + max_abs(unit_from_object.offset) + 3 * glm::length(ray.origin));
    INFO(i << ": t " << t[i] << ", from " << double(expected.t_enter) << " to " << double(expected.t_leave)
           << ", least " << least << ", slack " << slack);
    if (std::abs(least) < slack || std::abs(double(expected.t_leave)) * glm::length(ray.direction) < slack) {
      ++unclear;
    } else if (is_hit != (least < 0 && expected.t_leave > 0)) {
      FAIL("hit or miss");
    } else if (is_hit) {
      // Off the surface by no more than the roundings of the line: that is how far from the exact t it may be.
      Vec3 const p = ray.at(t[i]);
      if (std::abs(double(body({p.x, p.y, p.z}))) > 2 * slack)
        FAIL("not on the surface: " << double(body({p.x, p.y, p.z})));
      bool const is_first = std::abs(t[i] - double(expected.t_enter)) <= std::abs(t[i] - double(expected.t_leave));
      double const near_end = std::abs(double(expected.t_enter)) * glm::length(ray.direction);
      if (near_end > slack && is_first != (expected.t_enter > 0) && least < -4 * slack) FAIL("the wrong end");
    }
  }
  if (count >= 1000) CHECK(hits > count / 5);
  CHECK(unclear <= 1 + count / 20);
}

/// One shape at rest and one ray a case.
class EdgeCases {
 public:
  void add(Vec3 const& origin, Vec3 const& direction, double t, float limit = float_infinity) {
    cases_.add({{to_device(Affine()), {}, {}}}, origin, direction, limit);
    expected_.push_back(float(t));
  }
  void check(std::string const& probe) const {
    NEEDS_OPENCL_DEVICE();
    auto const t = cases_.run(probe);
    for (std::size_t i = 0; i < t.size(); ++i) {
      INFO("case " << i);
      if (expected_[i] == float_infinity)
        CHECK(t[i] == float_infinity);
      else
        CHECK(t[i] == Approx(expected_[i]).epsilon(1e-6));
    }
  }

 private:
  ShapeCases<device::CylinderPrimitive> cases_;
  std::vector<float> expected_;
};

}  // namespace

TEST_CASE("Cylinder hits are the body's at every scale", "[kernel]") {
  check_solid("probe_cylinder", 20, cylinder_body({0, 0, 0}, {0, 1, 0}, 1));
}

TEST_CASE("Cylinder edge cases", "[kernel]") {
  EdgeCases cases;
  float const inf = float_infinity, nan = float_nan;
  Vec3 const left{-1, 0, 0}, down{0, -1, 0};
  cases.add({5, 0.5, 0}, left, 4);
  cases.add({5, 0.5, 0}, 4. * left, 1);          // any length of direction
  cases.add({0, 5, 0}, down, 4);                 // along the axis
  cases.add({0, -5, 0}, -down, 5);               //
  cases.add({0.3, 0.5, 0}, -down, 0.5);          // from inside, to an end
  cases.add({0.5, 0.5, 0}, left, 1.5);           // from inside, to the side
  cases.add({5, 1, 0}, left, 4);                 // within the plane of an end
  cases.add({5, 0, 0}, left, 4);                 //
  cases.add({5, 1.000001, 0}, left, inf);        // just past
  cases.add({5, 0.5, 1}, left, 5);               // touches the side
  cases.add({5, 0.5, 1.000001}, left, inf);      // just past
  cases.add({1, 5, 0}, down, 4);                 // runs down the side
  cases.add({1.000001, 5, 0}, down, inf);        //
  cases.add({5, 0.5, 0}, -left, inf);            // behind
  cases.add({1, 0.5, 0}, -left, inf);            // from the side outwards
  cases.add({1, 0.5, 0}, left, 2);               // from the side inwards: t = 0 does not count
  cases.add({0, 1, 0}, -down, inf);              // from an end outwards
  cases.add({0, 1, 0}, down, 1);                 // and inwards
  cases.add({5, 0.5, 0}, left, inf, 4);          // t_max is exclusive
  cases.add({0, 1e6, 0}, down, 1e6);             // from far away along the axis
  cases.add({1e6, 0.5, 0}, left, 1e6);           // and at right angles
  cases.add({0, 1e6, 0}, {1e-6, -1, 0}, 1e6);    // meets the end at its rim
  cases.add({0, 1e6, 0}, {2e-6, -1, 0}, inf);    // passes it
  cases.add({0.5, -1e-3, 0}, {0, 1e-4, 0}, 10);  // close below
  cases.add({nan, 0.5, 0}, left, inf);
  cases.add({5, 0.5, 0}, {nan, 0, 0}, inf);
  cases.add({5, 0.5, 0}, {0, 0, 0}, inf);
  cases.add({0, 0.5, 0}, {0, 0, 0}, inf);
  cases.check("probe_cylinder");
}

TEST_CASE("Cone hits are the body's at every scale", "[kernel]") {
  check_solid("probe_cone", 21, cone_body({0, 0, 0}, {0, 1, 0}, 1));
}

TEST_CASE("Cone edge cases", "[kernel]") {
  EdgeCases cases;
  float const inf = float_infinity, nan = float_nan;
  Vec3 const left{-1, 0, 0}, down{0, -1, 0};
  cases.add({5, 0.5, 0}, left, 4.5);
  cases.add({5, 0.5, 0}, 4. * left, 1.125);          // any length of direction
  cases.add({0, 5, 0}, down, 4);                     // along the axis, onto the tip
  cases.add({0, -5, 0}, -down, 5);                   // and onto the base
  cases.add({0.25, 5, 0}, down, 4.25);               // steep, onto the side
  cases.add({0.25, 0.25, 0}, -down, 0.5);            // from inside, to the side
  cases.add({0.25, 0.25, 0}, down, 0.25);            // from inside, to the base
  cases.add({5, 0, 0}, left, 4);                     // within the plane of the base
  cases.add({5, 1.000001, 0}, left, inf);            // just over the tip
  cases.add({0, 3, 0}, left, inf);                   // through the other half of the double cone
  cases.add({5, 3, 0}, left, inf);                   //
  cases.add({2, 5, 0}, down, inf);                   // through it, and below the base into this half
  cases.add({1, 5, 1}, {-0.25, -1, -0.25}, 4);       // through it and the tip
  cases.add({2.5, 3, 0}, {-1, -1, 0}, 2.25);         // parallel to the left side, onto the right one
  cases.add({1.5, 3, 0}, {-1, -1, 0}, inf);          // parallel to it, outside
  cases.add({-3.75, 4.25, 0}, {1, -1, 0}, 3.5);      // parallel to the right side, onto the left one
  cases.add({-3, 4.25, 0}, {1, -1, 0}, inf);         // parallel to it, outside
  cases.add({5, 0.5, 0}, -left, inf);                // behind
  cases.add({0.5, 0.5, 0}, -left, inf);              // from the side outwards
  cases.add({0.5, 0.5, 0}, left, 1);                 // and inwards
  cases.add({5, 0.5, 0}, left, inf, 4.5f);           // t_max is exclusive
  cases.add({0.25, 1e6, 0}, down, 1e6 - 0.75);       // from far away
  cases.add({1e6, 0.5, 0}, left, 1e6 - 0.5);         //
  cases.add({1e6, 1e6, 0}, {-1, -1, 0}, 1e6 - 0.5);  // and parallel to the side
  cases.add({nan, 0.5, 0}, left, inf);
  cases.add({5, 0.5, 0}, {nan, 0, 0}, inf);
  cases.add({0, 0.5, 0}, {0, 0, 0}, inf);
  cases.check("probe_cone");
}

TEST_CASE("Plane hits lie on it, however far away", "[kernel]") {
  NEEDS_OPENCL_DEVICE();
  Random random(22);
  ShapeCases<device::CylinderPrimitive> cases;
  std::size_t const count = scaled_count(20000);
  for (std::size_t i = 0; i < count; ++i) {
    double const scale = std::array{1e-3, 1., 1e6}[i % 3];
    Affine const object_from_unit = random_affine(random, scale, 5 * scale);
    auto const [origin, direction] = random_ray(random, object_from_unit.offset, scale);
    cases.add({{to_device(object_from_unit.inverse()), {}, {}}}, origin, direction);
  }
  auto const t = cases.run("probe_plane");
  std::size_t hits = 0;
  for (std::size_t i = 0; i < count; ++i) {
    Affine const unit_from_object = from_device(cases.primitives[i].unit_from_object);
    Vec3 const o = to_vec3(cases.rays[i].origin), d = to_vec3(cases.rays[i].direction);
    double const height = unit_from_object.point(o).y;
    double const rise = (unit_from_object.linear * d).y;
    Vec3 const row(unit_from_object.linear[0].y, unit_from_object.linear[1].y, unit_from_object.linear[2].y);
    double const terms = glm::dot(glm::abs(row), glm::abs(o)) + std::abs(unit_from_object.offset.y);
    double const rise_terms = glm::dot(glm::abs(row), glm::abs(d));
    INFO(i << ": t " << t[i] << ", height " << height << ", rise " << rise);
    if (std::abs(height) < 8 * rounding_unit * terms || std::abs(rise) < 8 * rounding_unit * rise_terms) continue;
    double const expected = -height / rise;
    if ((t[i] < float_infinity) != (expected > 0)) FAIL("hit or miss");
    if (!(expected > 0)) continue;
    ++hits;
    double const slack = 8 * rounding_unit * (terms + expected * rise_terms) / std::abs(rise);
    if (std::abs(t[i] - expected) > slack) FAIL("distance");
  }
  CHECK(hits > count / 3);
}

TEST_CASE("Plane edge cases", "[kernel]") {
  EdgeCases cases;
  float const inf = float_infinity, nan = float_nan;
  cases.add({3, 2, 1}, {0, -1, 0}, 2);
  cases.add({3, 2, 1}, {0, -4, 0}, 0.5);      // any length of direction
  cases.add({3, -2, 1}, {5, 1, 0}, 2);        // from below
  cases.add({3, 2, 1}, {0, 1, 0}, inf);       // behind
  cases.add({3, 2, 1}, {1, 0, 0}, inf);       // parallel
  cases.add({3, 0, 1}, {1, 0, 0}, inf);       // within it
  cases.add({3, 0, 1}, {0, -1, 0}, inf);      // from it: t = 0 does not count
  cases.add({3, 2, 1}, {0, -1, 0}, inf, 2);   // t_max is exclusive
  cases.add({3, 2, 1}, {1, -1e-7, 0}, 2e7);   // grazing
  cases.add({3e6, 1e6, 1}, {0, -1, 0}, 1e6);  // far away
  cases.add({3, 1e-6, 1}, {0, -1, 0}, 1e-6);  // close by
  cases.add({3, 2, 1}, {0, 0, 0}, inf);       // no direction
  cases.add({3, nan, 1}, {0, -1, 0}, inf);
  cases.add({3, 2, 1}, {0, nan, 0}, inf);
  cases.check("probe_plane");
}

// A line steeper than the side is within the lower half below some point, whatever rounding makes of the discriminant.
TEST_CASE("Steep rays at a cone's tip do not slip past it", "[kernel]") {
  NEEDS_OPENCL_DEVICE();
  ShapeCases<device::CylinderPrimitive> cases;
  Random random(23);
  for (int i = 0; i < 20000; ++i) {
    double const angle = random.uniform(0, 6.3), slope = 1 - std::pow(10., random.uniform(-6, -0.1));
    Vec3 const direction(slope * std::cos(angle), -1, slope * std::sin(angle));
    cases.add({{to_device(Affine()), {}, {}}}, Vec3(0, 1, 0) - 3. * direction, direction);
  }
  auto const t = cases.run("probe_cone");
  CHECK(std::count_if(t.begin(), t.end(), [](float t_hit) { return t_hit < float_infinity; }) == 20000);
}
