#include <array>
#include <random>
#include <sstream>

#include "lichtraum/shapes.hpp"
#include "support/catch.hpp"
#include "support/convex_oracle.hpp"
#include "support/shape_hit.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

TEST_CASE("a cylinder is met where the numbers say, from every distance", "[unit][shape]") {
  std::mt19937_64 random(5);
  auto const number = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  auto const point = [&](double reach) {
    return Vec3(number(-reach, reach), number(-reach, reach), number(-reach, reach));
  };
  std::size_t hits = 0, inside = 0;
  for (int i = 0; i < 6000; ++i) {
    Vec3 const p1 = point(2), p2 = p1 + point(2);
    double const radius = number(0.05, 1.5);
    Cylinder const cylinder("c", p1, p2, radius, nullptr);
    Vec3 const center = 0.5 * (p1 + p2);
    double const reach = radius + glm::length(p2 - p1);
    double const distance = std::array{0.1, 3., 1e3, 1e6}[std::size_t(i) % 4];
    Vec3 const origin = center + point(1) * distance;
    Ray const towards{origin, (center + point(0.6 * reach) - origin) * number(0.1, 3)};
    ConvexCrossing const expected = cross_convex(towards, center, reach, cylinder_body(p1, p2, radius));
    if (std::abs(double(expected.least)) < 1e-9) continue;
    INFO(i << ": from " << distance << ", least " << double(expected.least));
    Hit hit;
    bool const is_hit = cylinder.closest_hit(towards, 0, hit);
    REQUIRE(is_hit == (expected.least < 0 && expected.t_leave > 0));
    if (!is_hit) continue;
    ++hits;
    bool const is_inside = expected.t_enter <= 0;
    inside += is_inside;
    double const t = double(is_inside ? expected.t_leave : expected.t_enter);
    double const slack = 1e-12 * (distance + reach) / std::sqrt(std::abs(double(expected.least)));
    REQUIRE(std::abs(hit.t - t) * glm::length(towards.direction) < slack);
    // Outwards: the ray goes against the normal where it enters.
    CHECK((glm::dot(hit.normal, towards.direction) < 0) == !is_inside);
    Vec3 const axis = glm::normalize(p2 - p1);
    double const along = glm::dot(hit.normal, axis);
    CHECK((std::abs(along) < 1e-6 || std::abs(along) > 1 - 1e-12));  // the side, or an end
    CHECK(cylinder_body(p1, p2, radius)({towards.at(hit.t).x, towards.at(hit.t).y, towards.at(hit.t).z}) <
          1e-9 * distance + 1e-9);
    Bounds const bounds = cylinder.bounds();
    for (int axis_number = 0; axis_number < 3; ++axis_number) {
      CHECK(towards.at(hit.t)[axis_number] >= bounds.min[axis_number] - 1e-9 * (1 + distance));
      CHECK(towards.at(hit.t)[axis_number] <= bounds.max[axis_number] + 1e-9 * (1 + distance));
    }
  }
  CHECK(hits > 2000);
  CHECK(inside > 200);
}

TEST_CASE("a cylinder has a side and two ends, and belongs to itself", "[unit][shape]") {
  Cylinder const c("c", {0, 0, 0}, {0, 2, 0}, 1, nullptr);
  CHECK(hit_of(c, {5, 1, 0}, {-1, 0, 0}).t == 4);
  CHECK(is_normal(hit_of(c, {5, 1, 0}, {-1, 0, 0}), {1, 0, 0}));
  CHECK(hit_of(c, {0, 5, 0}, {0, -1, 0}).t == 3);  // along the axis
  CHECK(is_normal(hit_of(c, {0, 5, 0}, {0, -1, 0}), {0, 1, 0}));
  CHECK(is_normal(hit_of(c, {0, -5, 0}, {0, 2, 0}), {0, -1, 0}));
  CHECK(hit_of(c, {0, -5, 0}, {0, 2, 0}).t == 2.5);
  CHECK(hit_of(c, {0.5, 1, 0}, {0, 1, 0}).t == 1);  // from inside, to an end
  CHECK(is_normal(hit_of(c, {0.5, 1, 0}, {0, 1, 0}), {0, 1, 0}));
  CHECK(hit_of(c, {0.5, 1, 0}, {1, 0, 0}).t == 0.5);       // from inside, to the side
  CHECK(hit_of(c, {5, 2, 0}, {-1, 0, 0}).t == 4);          // within the plane of an end
  CHECK(hit_of(c, {5, 1, 1}, {-1, 0, 0}).t == Approx(5));  // touches the side
  CHECK(hit_of(c, {1, 5, 0}, {0, -1, 0}).t == 3);          // runs down the side
  double const none = std::numeric_limits<double>::infinity();
  CHECK(hit_of(c, {5, 2.000001, 0}, {-1, 0, 0}).t == none);
  CHECK(hit_of(c, {5, 1, 1.000001}, {-1, 0, 0}).t == none);
  CHECK(hit_of(c, {1.000001, 5, 0}, {0, -1, 0}).t == none);
  CHECK(hit_of(c, {5, 1, 0}, {1, 0, 0}).t == none);  // behind
  CHECK(hit_of(c, {0, 1, 0}, {0, 0, 0}).t == none);  // no direction
  CHECK(hit_of(c, {0, NAN, 0}, {1, 0, 0}).t == none);
  CHECK(c.bounds().min == Vec3(-1, 0, -1));
  CHECK(c.bounds().max == Vec3(1, 2, 1));
  float t = -1;
  CHECK(c.intersect({{5, 1, 0}, {-1, 0, 0}}, t));
  CHECK(t == 4);
}

TEST_CASE("a cylinder prints, moves, and refuses what is none", "[unit][shape]") {
  auto const material = std::make_shared<Material>("red", Rgb(1), Rgb(1), Rgb(1), 1);
  Cylinder cylinder("pipe", {0, 0, 0}, {0, 2, 0.5}, 1.5, material);
  std::ostringstream text;
  text << cylinder;
  CHECK(text.str() == "cylinder 'pipe': 0 0 0 to 0 2 0.5, radius 1.5, material 'red'");
  Cylinder stretched("s", {0, 0, 0}, {0, 1, 0}, 1, nullptr);
  stretched.scale({2, 3, 1});
  stretched.translate({10, 0, 0});
  CHECK(hit_of(stretched, {20, 1.5, 0}, {-1, 0, 0}).t == Approx(8));
  CHECK(hit_of(stretched, {10, 9, 0}, {0, -1, 0}).t == Approx(6));
  CHECK(is_normal(hit_of(stretched, {20, 1.5, 0}, {-1, 0, 0}), {1, 0, 0}));
  for (double const radius : {0., -1., double(NAN), double(INFINITY)}) {
    CHECK_THROWS_AS(Cylinder("c", {0, 0, 0}, {0, 1, 0}, radius, nullptr), std::invalid_argument);
  }
  CHECK_THROWS_AS(Cylinder("c", {1, 2, 3}, {1, 2, 3}, 1, nullptr), std::invalid_argument);
  CHECK_THROWS_AS(Cylinder("c", {1, 2, 3}, {1, 2, NAN}, 1, nullptr), std::invalid_argument);
}
