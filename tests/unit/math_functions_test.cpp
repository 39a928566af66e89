#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>

#include "shared/math.h"
#include "support/catch.hpp"

using namespace lichtraum;

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

/// How far a float is from the exact value, in units in the last place of that; 1e9 where one is infinite, or not a
/// number, and the other is not.
double error_in_ulp(double exact, float got) {
  if (std::isnan(exact)) return std::isnan(got) ? 0 : 1e9;
  if (std::fabs(exact) > double(std::numeric_limits<float>::max())) return got == float(exact) ? 0 : 1e9;
  int exponent = 0;
  std::frexp(exact, &exponent);
  return std::fabs(double(got) - exact) / std::ldexp(1.0, std::max(exponent - 24, -149));
}

class Arguments {
 public:
  /// A float of any size, infinity included; not negative.
  float any_positive() {
    for (;;) {
      auto const x = std::bit_cast<float>(std::uint32_t(random_() & 0x7fffffffu));
      if (!std::isnan(x)) return x;
    }
  }
  float any() { return random_() % 2 == 0 ? any_positive() : -any_positive(); }
  float between(double a, double b) { return float(a + (b - a) * double(random_() >> 11) * 0x1p-53); }

 private:
  std::mt19937_64 random_{1};
};

/// The largest error of `count` arguments is at most `limit` ulp, and more than an eighth of that: else the limit, or
/// what is measured, is not what it seems.
template <class Errors>
void check_largest(std::string const& what, int count, double limit, Errors const& error) {
  double largest = 0;
  for (int i = 0; i < count; ++i) largest = std::max(largest, error(i));
  INFO(what << ": " << largest << " ulp");
  CHECK(largest <= limit);
  CHECK(largest > limit / 8);
}

void check_errors(int count) {
  Arguments arguments;
  check_largest("exp", count, 1, [&](int i) {
    float const x = i % 2 == 0 ? arguments.between(-105, 90) : arguments.any();
    return error_in_ulp(std::exp(double(x)), device::exp_of(x));
  });
  check_largest("log", count, 1, [&](int i) {
    float const x = i % 2 == 0 ? arguments.between(0.5, 2) : arguments.any_positive();
    return error_in_ulp(std::log(double(x)), device::log_of(x));
  });
  check_largest("sin and cos", count, 1.5, [&](int i) {
    double const range = i % 2 == 0 ? 8 : 32768;
    float const x = arguments.between(-range, range);
    float cosine;
    float const sine = device::sin_and_cos_of(x, &cosine);
    auto const error = [](double exact, float got) {
      return std::fabs(exact - double(got)) <= 0x1p-25 ? 0 : error_in_ulp(exact, got);
    };
    return std::max(error(std::sin(double(x)), sine), error(std::cos(double(x)), cosine));
  });
  check_largest("atan2", count, 3, [&](int i) {
    float const x = i % 2 == 0 ? arguments.between(-1, 1) : arguments.any();
    float const y = i % 2 == 0 ? arguments.between(-1, 1) : arguments.any();
    if (std::fabs(x) > 1e38f || std::fabs(y) > 1e38f) return 0.0;
    return error_in_ulp(std::atan2(double(y), double(x)), device::atan2_of(y, x));
  });
  check_largest("acos", count, 1.5, [&](int i) {
    float const x = i % 2 == 0 ? arguments.between(-1, 1) : arguments.any();
    return std::fabs(x) <= 1 ? error_in_ulp(std::acos(double(x)), device::acos_of(x)) : 0.0;
  });
  auto const check_power = [&](std::string const& what, double limit, double exponent) {
    check_largest(what, count, limit, [&](int i) {
      float const x = i % 2 == 0 ? arguments.between(0, 2) : arguments.any_positive();
      auto const y = float(arguments.between(-exponent, exponent) / std::log2(double(x)));
      if (!(y >= 0) || x == infinity) return 0.0;
      return error_in_ulp(std::pow(double(x), double(y)), device::pow_of(x, y));
    });
  };
  check_power("pow", 1.5, 16);
  check_power("pow, far from 1", 6, 160);
  check_largest("pow of sRGB", count, 1, [&](int) {
    float const x = arguments.between(0.003, 1);
    return error_in_ulp(std::pow(double(x), double(1 / 2.4f)), device::pow_of(x, 1 / 2.4f));
  });
}

}  // namespace

TEST_CASE("elementary functions are within their errors", "[unit][math]") { check_errors(1 << 18); }
TEST_CASE("elementary functions are within their errors, 2^24 times", "[unit][math][long]") { check_errors(1 << 24); }

TEST_CASE("elementary functions know their special values", "[unit][math]") {
  using namespace device;
  CHECK(pow_of(0, 0) == 1);
  CHECK(pow_of(infinity, 0) == 1);
  CHECK(pow_of(0, 1e-30f) == 0);
  CHECK(pow_of(1, 1e30f) == 1);
  CHECK(pow_of(0.5f, infinity) == 0);
  CHECK(pow_of(infinity, 0.5f) == infinity);
  CHECK(pow_of(2, 1e30f) == infinity);
  CHECK(pow_of(3, 4) == 81);
  CHECK(std::isnan(pow_of(not_a_number, 0.5f)));
  CHECK(exp_of(0) == 1);
  CHECK(exp_of(-infinity) == 0);
  CHECK(exp_of(infinity) == infinity);
  CHECK(exp_of(1000) == infinity);
  CHECK(std::isnan(exp_of(not_a_number)));
  CHECK(log_of(0) == -infinity);
  CHECK(log_of(1) == 0);
  CHECK(log_of(infinity) == infinity);
  CHECK(std::isnan(log_of(not_a_number)));
  float cosine = 0;
  CHECK(sin_and_cos_of(0, &cosine) == 0);
  CHECK(cosine == 1);
  CHECK(atan2_of(0, 0) == 0);
  CHECK(atan2_of(0, -2) == 3.14159274f);
  CHECK(atan2_of(-3, 0) == -1.57079637f);
  CHECK(acos_of(1) == 0);
  CHECK(acos_of(-1) == 3.14159274f);
}
