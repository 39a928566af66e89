#include "core/elementary.hpp"

#include <cmath>
#include <initializer_list>
#include <limits>

namespace lichtraum {
namespace {

// pi / 2 and ln 2 as sums: a double and what it lacks.
constexpr double half_pi = 1.5707963267948966, half_pi_low = 6.123233995736766e-17;
constexpr double ln_2 = 0.6931471805599453, ln_2_low = 2.3190468138462996e-17;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Horner's rule, the highest coefficient first.
double polynomial(std::initializer_list<double> coefficients, double x) {
  double sum = 0;
  for (double const c : coefficients) sum = std::fma(sum, x, c);
  return sum;
}

/// r + low of at most pi / 4, `quarters` quarters of a turn from the angle.
struct ReducedAngle {
  double r;
  double low;
  int quarters;
};

ReducedAngle reduce(double radians) {
  double const n = std::floor(std::fma(radians, 1 / half_pi, 0.5));
  double const difference = std::fma(-n, half_pi, radians);  // exact: nearly all of it cancels
  double const r = std::fma(-n, half_pi_low, difference);
  double const low = std::fma(-n, half_pi_low, difference - r);
  return {r, low, int(std::fmod(n, 4.0) + 4) % 4};
}

// Taylor's series: what they leave out is less than 2^-60 up to pi / 4.
double sine_near_zero(double r, double low) {
  double const r2 = r * r;
  double const rest = polynomial({1 / 355687428096000.0, -1 / 1307674368000.0, 1 / 6227020800.0, -1 / 39916800.0,
                                  1 / 362880.0, -1 / 5040.0, 1 / 120.0, -1 / 6.0},
                                 r2);
  return r + std::fma(r * r2, rest, low);
}
double cosine_near_zero(double r, double low) {
  double const r2 = r * r;
  double const rest = polynomial({-1 / 6402373705728000.0, 1 / 20922789888000.0, -1 / 87178291200.0, 1 / 479001600.0,
                                  -1 / 3628800.0, 1 / 40320.0, -1 / 720.0, 1 / 24.0},
                                 r2);
  double const half = 0.5 * r2;
  double const first = 1 - half;
  return first + ((1 - first - half) + std::fma(r2 * r2, rest, -r * low));
}

double sine_after(double radians, int quarters) {
  if (!std::isfinite(radians)) return std::numeric_limits<double>::quiet_NaN();
  auto const [r, low, own_quarters] = reduce(radians);
  int const quarter = (own_quarters + quarters) % 4;
  double const size = quarter % 2 == 0 ? sine_near_zero(r, low) : cosine_near_zero(r, low);
  return quarter < 2 ? size : -size;
}

/// Of 0 <= t <= 1: twice the angle whose tangent is t / (1 + sqrt(1 + t^2)), and that once more.
double arc_tangent(double t) {
  double const half = t / (1 + std::sqrt(std::fma(t, t, 1.0)));
  double const quarter = half / (1 + std::sqrt(std::fma(half, half, 1.0)));
  double const q2 = quarter * quarter;
  double const rest = polynomial({1 / 25.0, -1 / 23.0, 1 / 21.0, -1 / 19.0, 1 / 17.0, -1 / 15.0, 1 / 13.0, -1 / 11.0,
                                  1 / 9.0, -1 / 7.0, 1 / 5.0, -1 / 3.0},
                                 q2);
  return 4 * std::fma(quarter * q2, rest, quarter);
}

}  // namespace

double sin_of(double radians) { return radians == 0 ? radians : sine_after(radians, 0); }
double cos_of(double radians) { return sine_after(radians, 1); }
double tan_of(double radians) { return sin_of(radians) / cos_of(radians); }

double atan2_of(double y, double x) {
  double const across = std::fabs(x), up = std::fabs(y);
  if (across == 0 && up == 0) return 0;
  double const turned = up > across ? half_pi - arc_tangent(across / up) : arc_tangent(up / across);
  double const angle = x < 0 ? (2 * half_pi - turned) + 2 * half_pi_low : turned;
  return std::copysign(angle, y);
}

double exp_of(double x) {
  if (!(x > -746)) return x < 0 ? 0 : x;
  if (x > 710) return infinity;
  double const n = std::floor(std::fma(x, 1 / ln_2, 0.5));
  double const difference = std::fma(-n, ln_2, x);
  double const r = std::fma(-n, ln_2_low, difference);
  double const low = std::fma(-n, ln_2_low, difference - r);
  double const rest = polynomial({1 / 87178291200.0, 1 / 6227020800.0, 1 / 479001600.0, 1 / 39916800.0, 1 / 3628800.0,
                                  1 / 362880.0, 1 / 40320.0, 1 / 5040.0, 1 / 720.0, 1 / 120.0, 1 / 24.0, 1 / 6.0, 0.5},
                                 r);
  return std::ldexp(1 + (r + std::fma(r * r, rest, low)), int(n));
}

double log_of(double x) {
  if (!(x > 0)) return x == 0 ? -infinity : std::numeric_limits<double>::quiet_NaN();
  if (x == infinity) return x;
  int exponent = 0;
  double m = std::frexp(x, &exponent);
  if (m < 0.7071067811865476) {
    m *= 2;
    --exponent;
  }
  // log(m) = 2 artanh(s) with s = (m - 1) / (m + 1), which is at most 0.172.
  double const s = (m - 1) / (m + 1);
  double const s_low = std::fma(-s, m + 1, m - 1) / (m + 1);
  double const s2 = s * s;
  double const rest = polynomial({1 / 25.0, 1 / 23.0, 1 / 21.0, 1 / 19.0, 1 / 17.0, 1 / 15.0, 1 / 13.0, 1 / 11.0,
                                  1 / 9.0, 1 / 7.0, 1 / 5.0, 1 / 3.0},
                                 s2);
  double const n = exponent;
  return std::fma(n, ln_2, 2 * s) + std::fma(n, ln_2_low, 2 * std::fma(s * s2, rest, s_low));
}

double pow_of(double x, double y) {
  if (y == 0) return 1;
  if (x == 0) return y > 0 ? 0 : infinity;
  return exp_of(y * log_of(x));
}

}  // namespace lichtraum
