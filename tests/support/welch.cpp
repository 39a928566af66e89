#include "support/welch.hpp"

#include <cmath>
#include <numbers>

namespace lichtraum::test {
namespace {

struct Estimate {
  double mean = 0;
  double error_squared = 0;  // variance of the mean
  double degrees = 0;        // of freedom
};
Estimate estimate(std::span<double const> values) {
  double const count = double(values.size());
  Estimate result;
  for (double const value : values) result.mean += value / count;
  for (double const value : values) result.error_squared += (value - result.mean) * (value - result.mean);
  result.degrees = count - 1;
  result.error_squared /= result.degrees * count;
  return result;
}

/// The integral of cos(x)^(degrees - 1) from `from` to pi / 2, by Simpson's rule: with tan(x) = t / sqrt(degrees), the
/// part of Student's distribution beyond t, up to a factor.
double tail(double from, double degrees) {
  constexpr int steps = 512;
  double const width = (std::numbers::pi / 2 - from) / steps;
  double sum = 0;
  for (int i = 0; i < steps; ++i) {  // nothing is left at pi / 2 itself
    double const weight = i == 0 ? 1 : i % 2 == 1 ? 4 : 2;
    sum += weight * std::pow(std::cos(from + i * width), degrees - 1);
  }
  return sum * width / 3;
}

}  // namespace

double welch_probability(std::span<double const> a, std::span<double const> b, double tolerance) {
  Estimate const x = estimate(a);
  Estimate const y = estimate(b);
  double const difference = std::abs(x.mean - y.mean);
  double const error_squared = x.error_squared + y.error_squared;
  if (difference <= tolerance) return 1;
  if (!(error_squared > 0)) return 0;
  double const degrees =
      error_squared * error_squared /
      (x.error_squared * x.error_squared / x.degrees + y.error_squared * y.error_squared / y.degrees);
  return tail(std::atan(difference / std::sqrt(error_squared * degrees)), degrees) / tail(0, degrees);
}

double sidak_level(double level, std::size_t count) { return -std::expm1(std::log1p(-level) / double(count)); }

}  // namespace lichtraum::test
