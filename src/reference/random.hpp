#pragma once

#include <cstdint>

namespace lichtraum {

/// Uniform numbers of one sample of one pixel: SplitMix64 (Steele, Lea and Flood, "Fast Splittable Pseudorandom Number
/// Generators", OOPSLA 2014), begun at a hash of the four numbers. Nothing of what the kernels draw.
class ReferenceRandom {
 public:
  ReferenceRandom(int x, int y, int sample, std::uint64_t seed) {
    for (std::uint64_t const number : {std::uint64_t(x), std::uint64_t(y), std::uint64_t(sample), seed}) {
      state_ = mixed(state_ + step) ^ mixed(number + step);
    }
  }

  /// 0 <= u < 1, a multiple of 2^-53.
  double uniform() { return double(mixed(state_ += step) >> 11) * 0x1p-53; }

 private:
  static constexpr std::uint64_t step = 0x9e3779b97f4a7c15;
  static std::uint64_t mixed(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
  }

  std::uint64_t state_ = 0;
};

}  // namespace lichtraum
