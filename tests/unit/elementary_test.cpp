#include "core/elementary.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>

#include "support/catch.hpp"

using namespace lichtraum;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// From x87's 64 bits, in units in the last place of `exact` as a double.
double error_in_ulp(long double exact, double got) {
  int exponent = 0;
  std::frexp(exact, &exponent);
  return double(std::fabs((long double)(got)-exact) / std::ldexp(1.0L, std::max(exponent - 53, -1074)));
}

/// The largest error of 200,000 arguments is at most `limit`, and more than a quarter of it: else the limit, or what is
/// measured, is not what it seems.
template <class Errors>
void check_largest(std::string const& what, double limit, Errors const& error) {
  std::mt19937_64 random(7);
  auto const between = [&](double a, double b) { return a + (b - a) * double(random() >> 11) * 0x1p-53; };
  double largest = 0;
  for (int i = 0; i < 200'000; ++i) largest = std::max(largest, error(between));
  INFO(what << ": " << largest);
  CHECK(largest <= limit);
  CHECK(largest > limit / 4);
}

}  // namespace

TEST_CASE("elementary functions of doubles are as exact as they say", "[unit][math]") {
  check_largest("sin", 1, [](auto const& between) {
    double const x = between(-1000, 1000);
    return error_in_ulp(std::sin((long double)(x)), sin_of(x));
  });
  check_largest("cos", 1, [](auto const& between) {
    double const x = between(-4, 4);
    return error_in_ulp(std::cos((long double)(x)), cos_of(x));
  });
  check_largest("tan", 3, [](auto const& between) {
    double const x = between(0, 1.57);
    return error_in_ulp(std::tan((long double)(x)), tan_of(x));
  });
  check_largest("atan2", 6, [](auto const& between) {
    double const y = between(-1, 1), x = between(-1, 1);
    return error_in_ulp(std::atan2((long double)(y), (long double)(x)), atan2_of(y, x));
  });
  check_largest("exp", 1, [](auto const& between) {
    double const x = between(-745, 709);
    return error_in_ulp(std::exp((long double)(x)), exp_of(x));
  });
  check_largest("log", 2, [](auto const& between) {
    double const x = between(0.1, 3);
    return error_in_ulp(std::log((long double)(x)), log_of(x));
  });
  check_largest("pow", 1, [](auto const& between) {
    double const x = between(0, 2), y = between(0, 300);
    double const power = pow_of(x, y);
    if (!(power > 1e-300)) return 0.0;
    double const limit = 4 + 4 * std::fabs(y * std::log(x));
    return error_in_ulp(std::pow((long double)(x), (long double)(y)), power) / limit;
  });
}

TEST_CASE("elementary functions of doubles at their ends", "[unit][math]") {
  CHECK(sin_of(0) == 0);
  CHECK(std::signbit(sin_of(-0.0)));
  CHECK(cos_of(0) == 1);
  CHECK(sin_of(1e-300) == 1e-300);
  CHECK(std::isnan(sin_of(infinity)));
  CHECK(std::isnan(cos_of(not_a_number)));
  CHECK(tan_of(0.7853981633974483) == Approx(1).epsilon(1e-15));
  CHECK(atan2_of(0, 0) == 0);
  CHECK(atan2_of(0, 3) == 0);
  CHECK(atan2_of(0, -3) == 3.141592653589793);
  CHECK(atan2_of(-2, 0) == -1.5707963267948966);
  CHECK(atan2_of(1e-300, 1) == 1e-300);
  CHECK(atan2_of(1e300, 1e-300) == 1.5707963267948966);
  CHECK(exp_of(0) == 1);
  CHECK(exp_of(-infinity) == 0);
  CHECK(exp_of(infinity) == infinity);
  CHECK(exp_of(-745.1) == 5e-324);
  CHECK(exp_of(709.7) == Approx(std::exp(709.7)).epsilon(1e-15));
  CHECK(std::isnan(exp_of(not_a_number)));
  CHECK(log_of(1) == 0);
  CHECK(log_of(0) == -infinity);
  CHECK(log_of(infinity) == infinity);
  CHECK(log_of(5e-324) == Approx(-744.4400719213812).epsilon(1e-15));
  CHECK(std::isnan(log_of(-1)));
  CHECK(pow_of(0, 0) == 1);
  CHECK(pow_of(0, 2.5) == 0);
  CHECK(pow_of(1, 1e300) == 1);
  CHECK(pow_of(0.5, 1e300) == 0);
}
