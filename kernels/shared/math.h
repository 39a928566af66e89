#ifndef LICHTRAUM_SHARED_MATH_H
#define LICHTRAUM_SHARED_MATH_H

#include "shared/real.h"

/* Elementary functions of nothing but IEEE 754's exact operations: + - * / fma sqrt floor fabs copysign, comparisons
 * and conversions. So a picture's bytes do not depend on whose compiler, vectors and libraries compute it. The builtins
 * of OpenCL C and C++ that are not among these differ between processors and versions, and tools/lint forbids them.
 *
 * The errors are in units in the last place (ulp), the largest of 2^24 arguments (tests/unit/math_functions_test.cpp).
 * Polynomials are minimax, by Remez' exchange algorithm, rounded to float. */

DEVICE_NAMESPACE_BEGIN

/* 2^(high + low), |low| being small beside 1 unless the result is 0 or infinite. */
SHARED_FUNCTION Real exp2_of_sum(Real high, Real low) {
  Real const x = high > -160.0f ? (high < 160.0f ? high : (Real)(160.0f)) : (Real)(-160.0f);
  Real const n = floor(x + 0.5f);
  Real const f = (x - n) + (x == high ? low : (Real)(0.0f));
  Real p = (Real)(1.51961558e-05f);
  p = fma(p, f, (Real)(1.54667563e-04f));
  p = fma(p, f, (Real)(1.33339351e-03f));
  p = fma(p, f, (Real)(9.61803831e-03f));
  p = fma(p, f, (Real)(5.55041023e-02f));
  p = fma(p, f, (Real)(0.240226507f));
  p = fma(p, f, (Real)(0.693147182f));
  p = fma(p, f, (Real)(1.0f));
  /* In two steps, as 2^n itself need not be a float. */
  Whole const exponent = whole_of_real(n);
  Whole const first_exponent = exponent >> 1;
  Real const scaled =
      p * real_of_bits((first_exponent + 127) << 23) * real_of_bits((exponent - first_exponent + 127) << 23);
  return high == high ? scaled : high;
}

/* The base-2 logarithm of a positive number as a sum, within 2^-30 of itself. */
SHARED_FUNCTION Real log2_as_sum(Real x, Real* low) {
  Mask const is_small = x < 1.17549435e-38f;
  Whole const bits = bits_of_real(is_small ? x * 16777216.0f : x);
  Whole const exponent = (bits - 0x3f3504f3) >> 23;
  Real const m = real_of_bits(bits - (exponent << 23)); /* sqrt(1/2) <= m < sqrt(2) */
  Real const k = real_of_whole(exponent) - (is_small ? (Real)(24.0f) : (Real)(0.0f));
  /* log(m) = 2 artanh(s), s = (m - 1) / (m + 1); the denominator and s as sums as well. */
  Real const difference = m - 1.0f;
  Real const sum = m + 1.0f;
  Real const back = sum - 1.0f;
  Real const sum_low = (1.0f - (sum - back)) + (m - back);
  Real const s = difference / sum;
  Real const s_low = (fma(-s, sum, difference) - s * sum_low) / sum;
  Real const s2 = s * s;
  Real r = (Real)(0.340262085f);
  r = fma(r, s2, (Real)(0.411704183f));
  r = fma(r, s2, (Real)(0.577082872f));
  r = fma(r, s2, (Real)(0.961796701f));
  Real const scale = (Real)(2.88539004f); /* 2 / ln 2, with the next line */
  Real const scale_low = (Real)(3.85192607e-08f);
  Real const first = scale * s;
  Real const first_low = fma(scale, s, -first) + (scale_low * s + scale * s_low);
  Real const rest = first_low + s * s2 * r;
  Real const high = k + first;
  Real const high_low = (first - (high - k)) + rest;
  Real const result = high + high_low;
  *low = high_low - (result - high);
  return result;
}

/* x^y for x >= 0 and y >= 0, to 1.5 ulp between 2^-16 and 2^16 and to 6 beyond; 0^0 = 1. */
SHARED_FUNCTION Real pow_of(Real x, Real y) {
  Real low;
  Real const high = log2_as_sum(x, &low);
  Real const product = y * high;
  Real const power = exp2_of_sum(product, fma(y, high, -product) + y * low);
  Real const of_zero = y == 0.0f ? (Real)(1.0f) : (Real)(0.0f);
  Real const of_infinity = y == 0.0f ? (Real)(1.0f) : x; /* and of what is not a number */
  return x == 0.0f ? of_zero : (x < INFINITY ? power : of_infinity);
}

/* e^x, to 1 ulp. */
SHARED_FUNCTION Real exp_of(Real x) {
  Real const log2_e = (Real)(1.44269502f);
  Real const product = x * log2_e;
  Real const low = fma(x, log2_e, -product) + x * (Real)(1.92596303e-08f);
  return exp2_of_sum(product, low);
}

/* The natural logarithm of x >= 0, to 1 ulp; -infinity for 0. */
SHARED_FUNCTION Real log_of(Real x) {
  Real low;
  Real const high = log2_as_sum(x, &low);
  Real const ln_2 = (Real)(0.693147182f);
  Real const product = high * ln_2;
  Real const rest = fma(high, ln_2, -product) + (high * (Real)(-1.90465421e-09f) + low * ln_2);
  Real const result = x == 0.0f ? (Real)(-INFINITY) : product + rest;
  return x < INFINITY ? result : x;
}

/* The sine and the cosine of x radians, |x| <= 32768, each to 1.5 ulp or 2^-25. */
SHARED_FUNCTION Real sin_and_cos_of(Real x, Real* cosine) {
  Real const n = floor(fma(x, (Real)(0.636619747f), (Real)(0.5f)));
  /* x - n * pi / 2, with pi / 2 as three floats. */
  Real r = fma(n, (Real)(-1.57079637f), x);
  r = fma(n, (Real)(4.37113883e-08f), r);
  r = fma(n, (Real)(1.71512451e-15f), r);
  Real const r2 = r * r;
  Real s = (Real)(2.71727322e-06f);
  s = fma(s, r2, (Real)(-1.98392532e-04f));
  s = fma(s, r2, (Real)(8.33332911e-03f));
  s = fma(s, r2, (Real)(-0.166666672f));
  s = fma(s * r2, r, r);
  Real c = (Real)(2.44631665e-05f);
  c = fma(c, r2, (Real)(-1.38876494e-03f));
  c = fma(c, r2, (Real)(4.16666530e-02f));
  c = fma(c, r2, (Real)(-0.5f));
  c = fma(c, r2, (Real)(1.0f));
  Whole const quarter = whole_of_real(n) & 3;
  Mask const is_swapped = (quarter & 1) != 0;
  Real const sine = is_swapped ? c : s;
  Real const other = is_swapped ? s : c;
  *cosine = ((quarter + 1) & 2) != 0 ? -other : other;
  return (quarter & 2) != 0 ? -sine : sine;
}

/* The angle of the point (x, y) from the x axis, -pi .. pi, to 3 ulp; 0 for the origin. */
SHARED_FUNCTION Real atan2_of(Real y, Real x) {
  Real const across = fabs(x);
  Real const up = fabs(y);
  Mask const is_steep = up > across;
  Real const larger = is_steep ? up : across;
  Real const smaller = is_steep ? across : up;
  /* Above tan(pi / 8) as pi / 4 plus the angle of what is left. */
  Mask const is_wide = smaller > 0.414213562f * larger;
  Real const numerator = is_wide ? smaller - larger : smaller;
  Real const denominator = is_wide ? smaller + larger : (larger == 0.0f ? (Real)(1.0f) : larger);
  Real const t = numerator / denominator;
  Real const t2 = t * t;
  Real p = (Real)(-0.0608299412f);
  p = fma(p, t2, (Real)(0.105958298f));
  p = fma(p, t2, (Real)(-0.142438263f));
  p = fma(p, t2, (Real)(0.199984878f));
  p = fma(p, t2, (Real)(-0.333333164f));
  Real const turned = fma(p * t2, t, t);
  Real angle = is_wide ? turned + 0.785398185f : turned;
  angle = is_steep ? 1.57079637f - angle : angle;
  angle = x < 0.0f ? 3.14159274f - angle : angle;
  return copysign(angle, y);
}

/* The angle whose cosine is x, |x| <= 1: 0 .. pi, to 1.5 ulp. */
SHARED_FUNCTION Real acos_of(Real x) {
  Mask const is_middle = fabs(x) < 0.5f;
  Real const halved = 0.5f * (1.0f - fabs(x));
  Real const s = is_middle ? x : sqrt(halved);
  Real const s2 = is_middle ? x * x : halved;
  Real p = (Real)(0.0375665165f);
  p = fma(p, s2, (Real)(0.0144017125f));
  p = fma(p, s2, (Real)(0.0318178348f));
  p = fma(p, s2, (Real)(0.0445156954f));
  p = fma(p, s2, (Real)(0.0750051141f));
  p = fma(p, s2, (Real)(0.166666597f));
  Real const arc_sine = fma(p * s2, s, s);
  Real const outer = x < 0.0f ? 3.14159274f - 2.0f * arc_sine : 2.0f * arc_sine;
  return is_middle ? 1.57079637f - arc_sine : outer;
}

DEVICE_NAMESPACE_END

#endif
