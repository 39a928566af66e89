#include "scene/lowest_point.hpp"

#include <cmath>

#include "scene/flatten.hpp"
#include "support/catch.hpp"
#include "support/esdf.hpp"

using namespace lichtraum;

namespace {

double lowest(std::string const& shapes, Vec3 const& up = {0, 1, 0}) {
  Scene const scene = test::scene_of("define material m 0 0 0  1 1 1  0 0 0 1\n" + shapes);
  return lowest_point(flatten(scene.roots()), up);
}

/// Nine boxes of a unit's size in a row, shown twice: instances.
std::string const row = [] {
  std::string text, names;
  for (int i = 0; i < 9; ++i) {
    std::string const name = "b" + std::to_string(i), x = std::to_string(i);
    text += "define shape box " + name + " " + x + " 0 0  " + std::to_string(i + 1) + " 1 1 m\n";
    names += " " + name;
  }
  return text + "define shape composite row" + names +
         "\ndefine shape composite one row\ndefine shape composite two row\n";
}();

}  // namespace

TEST_CASE("the lowest point is that of shapes, however they are turned", "[unit][scene]") {
  double const diagonal = std::sqrt(0.5);
  CHECK(lowest("define shape sphere s 0 3 0 2 m\n") == Approx(1));
  CHECK(lowest("define shape sphere s 0 0 0 2 m\ntransform s rotate 45 1 0 0\n") == Approx(-2));
  CHECK(lowest("define shape sphere s 0 0 0 1 m\ntransform s scale 3 1 1\ntransform s rotate 90 0 0 1\n") ==
        Approx(-3));
  CHECK(lowest("define shape sphere s 0 0 0 1 m\ntransform s scale 3 1 1\ntransform s rotate 45 0 0 1\n") ==
        Approx(-std::sqrt(5)));
  CHECK(lowest("define shape box b -1 -1 -1 1 1 1 m\ntransform b rotate 45 0 0 1\n") == Approx(-std::sqrt(2)));
  CHECK(lowest("define shape triangle t 0 0 0  1 0 0  1 1 0 m\ntransform t rotate -45 0 0 1\n") == Approx(-diagonal));
  CHECK(lowest("define shape cylinder c 0 0 0  2 0 0  0.5 m\n") == Approx(-0.5));
  CHECK(lowest("define shape cylinder c 0 0 0  1 1 0  1 m\n") == Approx(-diagonal));
  CHECK(lowest("define shape cone c 0 0 0  0 -3 0  1 m\n") == Approx(-3));
  CHECK(lowest("define shape cone c 0 0 0  3 0 0  1 m\n") == Approx(-1));
}

TEST_CASE("the lowest point is that of instances, not of boxes around them", "[unit][scene]") {
  std::string const higher = "transform two translate 0 20 0\n";
  CHECK(lowest(row + higher) == Approx(0));
  CHECK(lowest(row + "transform one rotate 90 0 0 1\ntransform one translate 0 5 0\n" + higher) == Approx(5));
  CHECK(lowest(row + "transform one rotate -30 0 0 1\n" + higher) == Approx(-4.5));
  CHECK(lowest(row + "transform one rotate 30 1 0 0\ntransform two rotate -30 1 0 0\n") == Approx(-0.5));
  CHECK(lowest(row + "transform one scale 1 -1 1\n" + higher) == Approx(-1));
}

TEST_CASE("the lowest point is along up", "[unit][scene]") {
  double const half = std::sqrt(0.5);
  CHECK(lowest("define shape box b -1 -2 -3 4 5 6 m\n", {0, 0, 1}) == Approx(-3));
  CHECK(lowest("define shape box b -1 -2 -3 4 5 6 m\n", {0, -1, 0}) == Approx(-5));
  CHECK(lowest("define shape sphere s 2 0 0 1 m\n", {half, half, 0}) == Approx(2 * half - 1));
  CHECK(lowest("define shape cylinder c 0 0 0  0 0 2  0.5 m\n", {0, 0, -1}) == Approx(-2));
  CHECK(lowest(row + "transform one rotate 90 0 0 1\ntransform two translate 20 0 0\n", {1, 0, 0}) == Approx(-1));
  CHECK(lowest(row + "transform one translate 0 0 7\ntransform two translate 0 0 8\n", {0, 0, 1}) == Approx(7));
}

TEST_CASE("infinite planes have no lowest point, nor has nothing", "[unit][scene]") {
  CHECK(std::isinf(lowest("")));
  CHECK(std::isinf(lowest("define shape plane p 0 -9 0  0 1 0 m\n")));
  CHECK(lowest("define shape plane p 0 -9 0  0 1 0 m\ndefine shape sphere s 0 0 0 1 m\n") == Approx(-1));
}
