/* The functions of shared/math.h for LANES pairs of numbers a work-item, FUNCTION_COUNT results a pair. */
#include "math/real.clh"

#define FUNCTION_COUNT 6u

__kernel void probe_functions(__global float const* xs, __global float const* ys, __global float* results) {
  size_t const first = get_global_id(0) * LANES;
  float x_of[LANES];
  float y_of[LANES];
  for (uint lane = 0u; lane < LANES; ++lane) {
    x_of[lane] = xs[first + lane];
    y_of[lane] = ys[first + lane];
  }
  Real const x = load_real(x_of);
  Real const y = load_real(y_of);
  Real cosine;
  Real const sine = sin_and_cos_of(x, &cosine);
  Real const values[FUNCTION_COUNT] = {
      pow_of(fabs(x), fabs(y)), exp_of(x), log_of(fabs(x)), sine, cosine, fabs(x) < 1.f ? acos_of(x) : atan2_of(x, y)};
  for (uint i = 0u; i < FUNCTION_COUNT; ++i) {
    store_real(values[i], x_of);
    for (uint lane = 0u; lane < LANES; ++lane) {
      results[(first + lane) * FUNCTION_COUNT + i] = x_of[lane];
    }
  }
}

/* a * b + c, a * b - c * a and fma(a, b, c) for LANES numbers a work-item. */
__kernel void probe_products(__global float const* a_of, __global float const* b_of, __global float const* c_of,
                             __global float* results) {
  size_t const first = get_global_id(0) * LANES;
  float values[LANES];
  for (uint lane = 0u; lane < LANES; ++lane) {
    values[lane] = a_of[first + lane];
  }
  Real const a = load_real(values);
  for (uint lane = 0u; lane < LANES; ++lane) {
    values[lane] = b_of[first + lane];
  }
  Real const b = load_real(values);
  for (uint lane = 0u; lane < LANES; ++lane) {
    values[lane] = c_of[first + lane];
  }
  Real const c = load_real(values);
  Real const products[3] = {a * b + c, a * b - c * a, fma(a, b, c)};
  for (uint i = 0u; i < 3u; ++i) {
    store_real(products[i], values);
    for (uint lane = 0u; lane < LANES; ++lane) {
      results[(first + lane) * 3u + i] = values[lane];
    }
  }
}
