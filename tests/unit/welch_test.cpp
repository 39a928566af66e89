#include "support/welch.hpp"

#include <array>
#include <cmath>

#include "support/catch.hpp"

using namespace lichtraum::test;

namespace {

// Drawn once from normal distributions; what is expected of them was computed with the gamma function in Student's
// density.
constexpr std::array few{3.1, 2.9, 3.4, 3.0};
constexpr std::array many{3.6, 3.2, 4.1, 3.9, 3.3, 3.7, 4.4, 3.0};

}  // namespace

TEST_CASE("welch: the probability of a difference is Student's", "[welch]") {
  // Two measurements each with the same variance: Student's distribution of 2 degrees, which has a closed form.
  std::array const a{0.0, 2.0}, b{4.0, 6.0};
  double const t = 4 / std::sqrt(2.0);
  CHECK(welch_probability(a, b) == Approx(1 - t / std::sqrt(2 + t * t)));
  CHECK(welch_probability(few, many) == Approx(0.02033929).epsilon(1e-4));
  CHECK(welch_probability(few, many) == Approx(welch_probability(many, few)));
}

TEST_CASE("welch: what is the same, or nearly, gives 1, and what is certainly different 0", "[welch]") {
  std::array const same{1.0, 1.0, 1.0}, other{1.001, 1.001, 1.001};
  CHECK(welch_probability(same, same) == 1);
  CHECK(welch_probability(same, other) == 0);
  CHECK(welch_probability(same, other, 0.002) == 1);
}

TEST_CASE("welch: the level of many tests", "[welch]") {
  CHECK(sidak_level(0.05, 1) == Approx(0.05));
  CHECK(1 - std::pow(1 - sidak_level(0.01, 117), 117) == Approx(0.01));
}
