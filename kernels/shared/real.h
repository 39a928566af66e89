#ifndef LICHTRAUM_SHARED_REAL_H
#define LICHTRAUM_SHARED_REAL_H

#include "shared/types.h"

/* The types of math that is one text for C++ and for device programs of one lane or sixteen: a Real is a float, or a
 * lane for each of LANES floats (program.clh); a Mask says of each lane whether something holds. math/real.clh says how
 * they are used. */

#ifdef __OPENCL_C_VERSION__

#if LANES == 1
typedef float Real;
typedef int Whole;
typedef uint Word;
typedef int Mask;
static inline Whole bits_of_real(Real x) { return as_int(x); }
static inline Real real_of_bits(Whole bits) { return as_float(bits); }
static inline Real real_of_whole(Whole n) { return (float)n; }
static inline Whole whole_of_real(Real x) { return (int)x; }
static inline Whole whole_of_word(Word bits) { return (int)bits; }
static inline Word word_of_real(Real x) { return (uint)x; }
static inline Real real_at(__global float const* values) { return *values; }
static inline void put_real(Real x, __global float* values) { *values = x; }
#else
typedef float16 Real;
typedef int16 Whole;
typedef uint16 Word;
typedef int16 Mask;
static inline Whole bits_of_real(Real x) { return as_int16(x); }
static inline Real real_of_bits(Whole bits) { return as_float16(bits); }
static inline Real real_of_whole(Whole n) { return convert_float16(n); }
static inline Whole whole_of_real(Real x) { return convert_int16(x); }
static inline Whole whole_of_word(Word bits) { return as_int16(bits); }
static inline Word word_of_real(Real x) { return convert_uint16(x); }
static inline Real real_at(__global float const* values) { return vload16(0, values); }
static inline void put_real(Real x, __global float* values) { vstore16(x, 0, values); }
#endif

#else

#include <bit>
#include <cmath>

namespace lichtraum::device {
using std::copysign, std::fabs, std::floor, std::fma, std::sqrt;
using Real = float;
using Whole = std::int32_t;
using Word = std::uint32_t;
using Mask = bool;
inline Whole bits_of_real(Real x) { return std::bit_cast<Whole>(x); }
inline Real real_of_bits(Whole bits) { return std::bit_cast<Real>(bits); }
inline Real real_of_whole(Whole n) { return static_cast<Real>(n); }
inline Whole whole_of_real(Real x) { return static_cast<Whole>(x); }
inline Whole whole_of_word(Word bits) { return static_cast<Whole>(bits); }
inline Real real_at(float const* values) { return *values; }
inline void put_real(Real x, float* values) { *values = x; }
}  // namespace lichtraum::device

#endif

#endif
