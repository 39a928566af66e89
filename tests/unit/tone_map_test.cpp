#include "lichtraum/tone_map.hpp"

#include <limits>
#include <stdexcept>

#include "support/catch.hpp"

using namespace lichtraum;

TEST_CASE("without tone map and transfer function a pixel stays as computed", "[unit][tone_map]") {
  CHECK(develop({-1, 0.5, 7}, ToneMap::none, Transfer::linear) == Rgb(-1, 0.5, 7));
}

TEST_CASE("Reinhard's map is c / (c + 1)", "[unit][tone_map]") {
  CHECK(develop({0, 1, 3}, ToneMap::reinhard, Transfer::linear) == Rgb(0, 0.5, 0.75));
  double const infinity = std::numeric_limits<double>::infinity();
  CHECK(develop({infinity, 1e308, 1e-300}, ToneMap::reinhard, Transfer::linear) == Rgb(1, 1, 1e-300));
}

TEST_CASE("sRGB encodes as IEC 61966-2-1 says", "[unit][tone_map]") {
  Rgb const encoded = develop({0.002, 0.5, 1}, ToneMap::none, Transfer::srgb);
  CHECK(encoded.r == Approx(0.02584));
  CHECK(encoded.g == Approx(0.735356983));
  CHECK(encoded.b == Approx(1));
  // Both pieces meet.
  Rgb const joint = develop({0.0031308, 0.0031309, 0}, ToneMap::none, Transfer::srgb);
  CHECK(joint.r == Approx(0.04045).epsilon(1e-4));
  CHECK(joint.g == Approx(joint.r).epsilon(1e-4));
  CHECK(develop({1, 1, 1}, ToneMap::reinhard, Transfer::srgb).r == Approx(0.735356983));
}

TEST_CASE("an undecided tone map is refused", "[unit][tone_map]") {
  CHECK_THROWS_AS(develop({1, 1, 1}, ToneMap::automatic, Transfer::linear), std::invalid_argument);
}
