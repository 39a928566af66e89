#include "lichtraum/light.hpp"

#include <cmath>
#include <sstream>

#include "support/catch.hpp"

using namespace lichtraum;

namespace {

std::string text_of(Light const& light) {
  std::ostringstream out;
  out << light;
  return out.str();
}

}  // namespace

TEST_CASE("what arrives of a light", "[unit]") {
  CHECK(Light::point("", {0, 0, 0}, Rgb(2)).arriving_at({0, 0, 10}) == Rgb(2));
  CHECK(Light::directional("", {0, -2, 0}, Rgb(2)).arriving_at({5, 6, 7}) == Rgb(2));
  CHECK(Light::falling_off("", {0, 0, 0}, Rgb(8)).arriving_at({0, 0, 2}) == Rgb(2));
  CHECK(Light::falling_off("", {0, 0, 0}, Rgb(8), 4).arriving_at({0, 0, 2}) == Rgb(2 * (1 - 1.0 / 16)));
  CHECK(Light::falling_off("", {0, 0, 0}, Rgb(8), 2).arriving_at({0, 0, 2}) == Rgb(0));
  CHECK(Light::falling_off("", {0, 0, 0}, Rgb(8), 1).arriving_at({0, 0, 2}) == Rgb(0));
  Light const spot = Light::spot("", {0, 0, 0}, {0, 0, -3}, Rgb(1), {30, 60});
  CHECK(spot.get<SpotLight>()->direction == Vec3(0, 0, -1));
  CHECK(spot.arriving_at({0, 0, -1}) == Rgb(1));
  CHECK(spot.arriving_at(Vec3(0.5, 0, -0.866025404)).r == Approx(1));  // 30 degrees
  CHECK(spot.arriving_at(Vec3(0.866025404, 0, -0.5)).r == Approx(0).margin(1e-9));
  double const between = (std::sqrt(0.5) - 0.5) / (std::sqrt(0.75) - 0.5);
  CHECK(spot.arriving_at({1, 0, -1}).r == Approx(between * between / 2));
  CHECK(spot.arriving_at({0, 0, 1}) == Rgb(0));
}

TEST_CASE("lights that cannot be are refused", "[unit]") {
  CHECK_THROWS_AS(Light::falling_off("", {}, Rgb(1), 0), std::invalid_argument);
  CHECK_THROWS_AS(Light::directional("", Vec3(0), Rgb(1)), std::invalid_argument);
  CHECK_THROWS_AS(Light::spot("", {}, Vec3(0), Rgb(1), {0, 30}), std::invalid_argument);
  CHECK_THROWS_AS(Light::spot("", {}, {0, 0, 1}, Rgb(1), {30, 30}), std::invalid_argument);
  CHECK_THROWS_AS(Light::spot("", {}, {0, 0, 1}, Rgb(1), {0, 91}), std::invalid_argument);
  CHECK_THROWS_AS(Light::spot("", {}, {0, 0, 1}, Rgb(1), {-1, 30}), std::invalid_argument);
  CHECK_THROWS_AS(Light::spot("", {}, {0, 0, 1}, Rgb(1), {0, 30}, -1), std::invalid_argument);
  for (double const radius : {-1.0, double(INFINITY), double(NAN)}) {
    PointLight lamp;
    lamp.radius = radius;
    CHECK_THROWS_AS(Light("", lamp), std::invalid_argument);
  }
}

TEST_CASE("a light says what it is", "[unit]") {
  CHECK(text_of(Light::ambient("a", Rgb(0.5))) == "ambient light 'a': la 0.5 0.5 0.5");
  CHECK(text_of(Light::point("p", {1, 2, 3}, Rgb(1))) == "point light 'p': ld 1 1 1, position 1 2 3");
  CHECK(text_of(Light::directional("d", {0, 0, 2}, Rgb(1))) == "directional light 'd': ld 1 1 1, direction 0 0 1");
  CHECK(text_of(Light::spot("s", {1, 2, 3}, {0, 0, 2}, Rgb(1), {10, 20}, 7)) ==
        "spot light 's': ld 1 1 1, position 1 2 3, direction 0 0 1, cone 10 20, range 7");
}
