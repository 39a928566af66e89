#pragma once

namespace lichtraum {

/// Elementary functions of doubles, of nothing but IEEE 754's exact operations: matrices, lenses and colours, and so
/// pictures, have the same bytes whatever the processor and the C library. (glibc has several of each function and
/// chooses by the processor; their last bits differ.) Errors in units in the last place (ulp) are the largest of
/// tests/unit/elementary_test.cpp. What is not a number gives the same. The kernels' are in shared/math.h.

/// Sine, cosine and tangent of |radians| <= 2^20: to 1, 1 and 3 ulp, or 2^-60 near their zeros.
double sin_of(double radians);
double cos_of(double radians);
double tan_of(double radians);

/// The angle of the point (x, y) from the x axis, -pi .. pi, to 6 ulp; 0 for the origin. Both must be finite.
double atan2_of(double y, double x);

/// e^x, to 1 ulp; and to 2^-1074 where that is less.
double exp_of(double x);

/// The natural logarithm of x >= 0, to 2 ulp; -infinity for 0.
double log_of(double x);

/// x^y for x >= 0 and finite y, to 4 + 4 |y log(x)| ulp; 1 for y = 0.
double pow_of(double x, double y);

}  // namespace lichtraum
