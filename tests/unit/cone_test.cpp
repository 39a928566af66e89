#include <array>
#include <random>
#include <sstream>

#include "lichtraum/shapes.hpp"
#include "support/catch.hpp"
#include "support/convex_oracle.hpp"
#include "support/shape_hit.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

TEST_CASE("a cone is met where the numbers say, from every distance", "[unit][shape]") {
  std::mt19937_64 random(6);
  auto const number = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  auto const point = [&](double reach) {
    return Vec3(number(-reach, reach), number(-reach, reach), number(-reach, reach));
  };
  std::size_t hits = 0, inside = 0;
  for (int i = 0; i < 6000; ++i) {
    Vec3 const base = point(2), tip = base + point(2);
    double const radius = number(0.05, 1.5);
    Cone const cone("c", base, tip, radius, nullptr);
    Vec3 const center = 0.5 * (base + tip);
    double const reach = radius + glm::length(tip - base);
    double const distance = std::array{0.1, 3., 1e3, 1e6}[std::size_t(i) % 4];
    Vec3 const origin = center + point(1) * distance;
    Ray const towards{origin, (center + point(0.6 * reach) - origin) * number(0.1, 3)};
    ConvexCrossing const expected = cross_convex(towards, center, reach, cone_body(base, tip, radius));
    if (std::abs(double(expected.least)) < 1e-9) continue;
    INFO(i << ": from " << distance << ", least " << double(expected.least));
    Hit hit;
    bool const is_hit = cone.closest_hit(towards, 0, hit);
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
    double const along = glm::dot(hit.normal, glm::normalize(tip - base));
    double const on_side = radius / std::hypot(radius, glm::length(tip - base));
    CHECK((std::abs(along - on_side) < 1e-6 || along < -1 + 1e-12));  // the side, or the base
    CHECK(cone_body(base, tip, radius)({towards.at(hit.t).x, towards.at(hit.t).y, towards.at(hit.t).z}) <
          1e-9 * distance + 1e-9);
    Bounds const bounds = cone.bounds();
    for (int axis_number = 0; axis_number < 3; ++axis_number) {
      CHECK(towards.at(hit.t)[axis_number] >= bounds.min[axis_number] - 1e-9 * (1 + distance));
      CHECK(towards.at(hit.t)[axis_number] <= bounds.max[axis_number] + 1e-9 * (1 + distance));
    }
  }
  CHECK(hits > 2000);
  CHECK(inside > 200);
}

TEST_CASE("a cone has a side, a base and a tip", "[unit][shape]") {
  Cone const c("c", {0, 0, 0}, {0, 2, 0}, 1, nullptr);
  Vec3 const side = glm::normalize(Vec3(2, 1, 0));
  CHECK(hit_of(c, {5, 1, 0}, {-1, 0, 0}).t == 4.5);
  CHECK(is_normal(hit_of(c, {5, 1, 0}, {-1, 0, 0}), side));
  CHECK(hit_of(c, {0.5, 5, 0}, {0, -1, 0}).t == Approx(4));  // steep
  CHECK(is_normal(hit_of(c, {0.5, 5, 0}, {0, -1, 0}), side));
  CHECK(hit_of(c, {0, 5, 0}, {0, -1, 0}).t == 3);  // onto the tip
  CHECK(is_normal(hit_of(c, {0, 5, 0}, {0, -1, 0}), {0, 1, 0}));
  CHECK(hit_of(c, {0.5, -1, 0}, {0, 1, 0}).t == 1);  // onto the base
  CHECK(is_normal(hit_of(c, {0.5, -1, 0}, {0, 1, 0}), {0, -1, 0}));
  CHECK(hit_of(c, {0.5, 0.5, 0}, {0, -1, 0}).t == 0.5);  // from inside
  CHECK(hit_of(c, {0, 1, 0}, {1, 0, 0}).t == 0.5);
  CHECK(hit_of(c, {0.25, 0.5, 0}, {0, 1, 0}).t == Approx(1));
  CHECK(hit_of(c, {2.5, 4, 0}, {-1, -2, 0}).t == Approx(1.75));  // parallel to the side, onto the other
  double const none = std::numeric_limits<double>::infinity();
  CHECK(hit_of(c, {3.000001, 4, 0}, {-0.5, -1, 0}).t == none);  // parallel to the side, outside
  CHECK(hit_of(c, {5, 3, 0}, {-1, 0, 0}).t == none);            // where the other half of the double cone would be
  CHECK(hit_of(c, {0, 3, 0}, {0, 1, 0}).t == none);
  CHECK(hit_of(c, {5, 2.000001, 0}, {-1, 0, 0}).t == none);
  CHECK(hit_of(c, {5, -0.000001, 0}, {-1, 0, 0}).t == none);
  CHECK(hit_of(c, {5, 1, 0}, {1, 0, 0}).t == none);  // behind
  CHECK(hit_of(c, {0, 1, 0}, {0, 0, 0}).t == none);  // no direction
  CHECK(hit_of(c, {NAN, 1, 0}, {1, 0, 0}).t == none);
  CHECK(c.bounds().min == Vec3(-1, 0, -1));
  CHECK(c.bounds().max == Vec3(1, 2, 1));
}

TEST_CASE("a cone prints, moves, and refuses what is none", "[unit][shape]") {
  std::ostringstream text;
  text << Cone("hat", {0, 0, 0}, {0, 2, 0.5}, 1.5, nullptr);
  CHECK(text.str() == "cone 'hat': base 0 0 0, tip 0 2 0.5, radius 1.5");
  Cone stretched("s", {0, 0, 0}, {0, 1, 0}, 1, nullptr);
  stretched.scale({2, 4, 1});
  stretched.translate({10, 0, 0});
  CHECK(hit_of(stretched, {20, 2, 0}, {-1, 0, 0}).t == Approx(9));
  CHECK(glm::length(hit_of(stretched, {20, 2, 0}, {-1, 0, 0}).normal - glm::normalize(Vec3(2, 1, 0))) < 1e-12);
  for (double const radius : {0., -1., double(NAN), double(INFINITY)}) {
    CHECK_THROWS_AS(Cone("c", {0, 0, 0}, {0, 1, 0}, radius, nullptr), std::invalid_argument);
  }
  CHECK_THROWS_AS(Cone("c", {1, 2, 3}, {1, 2, 3}, 1, nullptr), std::invalid_argument);
}
