#ifndef LICHTRAUM_SHARED_SOBOL_H
#define LICHTRAUM_SHARED_SOBOL_H

#include "shared/real.h"

/* Points of the unit square that fill it evenly: Sobol's first two dimensions, shuffled and scrambled as Owen has it,
 * anew for each pixel and each use ("padding"), so that any number of uses stays even: Burley, "Practical Hash-based
 * Owen Scrambling", Journal of Computer Graphics Techniques 9(4), 2020. Any first N samples are even, best where N is a
 * power of two. Integers and exact conversions only: the same for host and device. */

DEVICE_NAMESPACE_BEGIN

/* 0 <= x, y < 1, multiples of 2^-24. */
typedef struct {
  Real x;
  Real y;
} SobolPoint;

SHARED_FUNCTION Word reverse_bits(Word v) {
  v = v << 16u | v >> 16u;
  v = (v & 0x00ff00ffu) << 8u | (v & 0xff00ff00u) >> 8u;
  v = (v & 0x0f0f0f0fu) << 4u | (v & 0xf0f0f0f0u) >> 4u;
  v = (v & 0x33333333u) << 2u | (v & 0xccccccccu) >> 2u;
  return (v & 0x55555555u) << 1u | (v & 0xaaaaaaaau) >> 1u;
}

/* Owen's scrambling of numbers whose bits are reversed: each bit may be flipped by those below it alone. Laine and
 * Karras, "Stratified Sampling for Stochastic Transparency", 2011; Burley's constants. */
SHARED_FUNCTION Word scramble_reversed(Word v, Word seed) {
  v += seed;
  v ^= v * 0x6c50b47cu;
  v ^= v * 0xb82f1e52u;
  v ^= v * 0xc7afe638u;
  v ^= v * 0x8d22f6e6u;
  return v;
}

/* The bits of Sobol's second dimension, reversed. Its generator matrix is Pascal's triangle modulo 2, in which column k
 * has row j where all bits of j are in k (Lucas): sums over supersets, a bit of the positions at a time. */
SHARED_FUNCTION Word sobol_second_reversed(Word v) {
  v ^= (v >> 1u) & 0x55555555u;
  v ^= (v >> 2u) & 0x33333333u;
  v ^= (v >> 4u) & 0x0f0f0f0fu;
  v ^= (v >> 8u) & 0x00ff00ffu;
  return v ^ v >> 16u;
}

SHARED_FUNCTION Real unit_real(Word bits) { return real_of_whole(whole_of_word(bits >> 8u)) * (1.0f / 16777216.0f); }

/* The dimension of points on the camera's lens, beyond all of a path's. */
#define LENS_DIMENSION 0x40000000u

/* Point `sample` of the sequence that belongs to a pixel and a dimension (a number for each use). The hash is pcg4d
 * of Jarzynski and Olano (2020), as in shared/sampling.h. */
SHARED_FUNCTION SobolPoint sobol_point(Word pixel_x, Word pixel_y, Word dimension, Word sample, uint seed_low,
                                       uint seed_high) {
  Word x = pixel_x * 1664525u + 1013904223u;
  Word y = pixel_y * 1664525u + 1013904223u + seed_high * 2654435769u;
  Word z = dimension * 1664525u + 1013904223u;
  Word w = x ^ x;
  SobolPoint point;
  Word index;
  w += seed_low * 1664525u + 1013904223u;
  x += y * w;
  y += z * x;
  z += x * y;
  w += y * z;
  x ^= x >> 16u;
  y ^= y >> 16u;
  z ^= z >> 16u;
  w ^= w >> 16u;
  x += y * w;
  y += z * x;
  z += x * y;
  index = reverse_bits(scramble_reversed(reverse_bits(sample), z));
  point.x = unit_real(reverse_bits(scramble_reversed(index, x)));
  point.y = unit_real(reverse_bits(scramble_reversed(sobol_second_reversed(index), y)));
  return point;
}

DEVICE_NAMESPACE_END

#endif
