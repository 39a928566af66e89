#include "view/edited_number.hpp"

#include <limits>

#include "support/catch.hpp"

using lichtraum::view::edited_channel;
using lichtraum::view::edited_number;
using lichtraum::view::rest_of;

TEST_CASE("a number that a widget changes has no more digits than the widget, and else stays", "[unit][view]") {
  CHECK(edited_number(0.9, 0.763f) == 0.763);
  CHECK(edited_number(0, 1e-20f) == 1e-20);
  CHECK(edited_number(1, -12345.678f) == -12345.678);
  CHECK(edited_number(0.1, 0.1f) == 0.1);
  CHECK(edited_number(1.0 / 3, float(1.0 / 3)) == 1.0 / 3);
  CHECK(edited_number(7.2, std::numeric_limits<float>::infinity()) == 7.2);
  CHECK(edited_number(7.2, std::numeric_limits<float>::quiet_NaN()) == 7.2);
}

TEST_CASE("a channel that is typed is one that eSDF takes", "[unit][view]") {
  CHECK(edited_channel(0.9, 0.763f) == 0.763);
  CHECK(edited_channel(0.9, 1e31f) == 1e30);
  CHECK(edited_channel(0.9, 1e30f) == 1e30);
  CHECK(edited_channel(0.9, -1) == 0);
  CHECK(edited_channel(-0.5, -0.5f) == -0.5);  // as the scene has it
  CHECK(edited_channel(0.9, std::numeric_limits<float>::infinity()) == 0.9);
}

TEST_CASE("what a share leaves another one has no digits that come from rounding", "[unit][view]") {
  CHECK(rest_of(0.7) == 0.3);
  CHECK(rest_of(0) == 1);
  CHECK(rest_of(1) == 0);
  CHECK(rest_of(0.12345679) == 0.87654321);
  for (int i = 0; i <= 1000; ++i) CHECK(i / 1000.0 + rest_of(i / 1000.0) <= 1);
  for (double const fine : {1e-13, 1.0 / 3, 0.1234567890123456}) CHECK(fine + rest_of(fine) <= 1);
}
