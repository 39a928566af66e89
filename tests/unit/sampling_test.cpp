#include "shared/sampling.h"

#include <array>
#include <cmath>
#include <vector>

#include "support/catch.hpp"

using lichtraum::device::seeded_pixel_offset;

namespace {

// pcg4d as its authors print it, on four words at once; the first two as integers of 24 bits.
std::array<std::uint32_t, 2> pcg4d(std::array<std::uint32_t, 4> v) {
  for (auto& word : v) word = word * 1664525u + 1013904223u;
  auto const mix = [&v] {
    v[0] += v[1] * v[3];
    v[1] += v[2] * v[0];
    v[2] += v[0] * v[1];
    v[3] += v[1] * v[2];
  };
  mix();
  for (auto& word : v) word ^= word >> 16;
  mix();
  return {v[0] >> 8, v[1] >> 8};
}

}  // namespace

TEST_CASE("seeded samples are pcg4d's bits as exact fractions", "[unit][sampling]") {
  for (std::uint32_t i = 0; i < 1000; ++i) {
    std::uint32_t const x = i * 7919u, y = i * i, sample = i % 17, seed = i * 2654435761u;
    auto const offset = seeded_pixel_offset(x, y, sample, seed, 0);
    auto const expected = pcg4d({x, y, sample, seed});
    REQUIRE(double(offset.x) * 16777216 == expected[0]);
    REQUIRE(double(offset.y) * 16777216 == expected[1]);
  }
}

TEST_CASE("each of pixel, sample and both halves of the seed moves the sample", "[unit][sampling]") {
  auto const base = seeded_pixel_offset(3, 4, 5, 6, 7);
  for (auto const& other :
       {seeded_pixel_offset(2, 4, 5, 6, 7), seeded_pixel_offset(3, 5, 5, 6, 7), seeded_pixel_offset(3, 4, 6, 6, 7),
        seeded_pixel_offset(3, 4, 5, 7, 7), seeded_pixel_offset(3, 4, 5, 6, 8)}) {
    CHECK(other.x != base.x);
    CHECK(other.y != base.y);
  }
}

TEST_CASE("seeded samples fill the pixel uniformly and independently", "[unit][sampling]") {
  // Over samples of one pixel, over neighbouring pixels, and over seeds: 16 x 16 cells, chi-squared with 255 degrees of
  // freedom, whose standard deviation is sqrt(2 * 255) = 22.6. Six of them make a false alarm a one in 10^8 event.
  int const way = GENERATE(0, 1, 2);
  constexpr int side = 16, count = 1 << 16;
  std::vector<int> cells(side * side);
  double sum_xy = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    auto const offset = way == 0   ? seeded_pixel_offset(17, 31, i, 1, 0)
                        : way == 1 ? seeded_pixel_offset(i % 256, i / 256, 0, 0, 0)
                                   : seeded_pixel_offset(0, 0, 0, i, 0);
    REQUIRE((offset.x >= 0 && offset.x < 1 && offset.y >= 0 && offset.y < 1));
    ++cells[std::size_t(int(offset.y * side) * side + int(offset.x * side))];
    sum_xy += (offset.x - 0.5) * (offset.y - 0.5);
  }
  double const expected = double(count) / (side * side);
  double chi_squared = 0;
  for (int const n : cells) chi_squared += (n - expected) * (n - expected) / expected;
  CHECK(std::abs(chi_squared - 255) < 6 * 22.6);
  CHECK(std::abs(sum_xy / count) < 6 * (1.0 / 12) / std::sqrt(double(count)));
}

TEST_CASE("the upper half of a seed gives other samples than any lower half alone", "[unit][sampling]") {
  // 0x161CA1C7F: what a seed of 1 in the upper half was folded into the same as 0.
  std::uint64_t const folded = 5935498823;
  int same = 0;
  for (std::uint32_t sample = 0; sample < 16; ++sample) {
    auto const zero = seeded_pixel_offset(3, 4, sample, 0, 0);
    auto const other = seeded_pixel_offset(3, 4, sample, std::uint32_t(folded), std::uint32_t(folded >> 32));
    same += zero.x == other.x && zero.y == other.y;
  }
  CHECK(same == 0);
}
