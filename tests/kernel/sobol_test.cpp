/// Sobol's points: the numbers that others have published, what makes them even, and that they are many independent
/// ones.

#include "shared/sobol.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "reference.hpp"
#include "support/catch.hpp"
#include "support/opencl_probe.hpp"
#include "support/skip.hpp"

using namespace lichtraum;
using namespace lichtraum::test;
using device::SobolPoint;
using device::uint;

namespace {

/// Which sequence.
struct Key {
  uint pixel_x = 0, pixel_y = 0, dimension = 0, seed_low = 0, seed_high = 0;
};
SobolPoint point_of(Key const& key, uint sample) {
  return device::sobol_point(key.pixel_x, key.pixel_y, key.dimension, sample, key.seed_low, key.seed_high);
}

Key random_key(Random& random) {
  auto const word = [&](std::size_t count) { return uint(random.index(count)); };
  return {word(4000), word(4000), word(64), word(1ull << 32), word(1ull << 32)};
}

/// Neighbours of a sequence: what two pixels, two bounces, two frames of a film have.
std::vector<std::pair<std::string, Key>> neighbours(Key const& key) {
  std::vector<std::pair<std::string, Key>> all(5, {"", key});
  all[0].first = "column", ++all[0].second.pixel_x;
  all[1].first = "row", ++all[1].second.pixel_y;
  all[2].first = "dimension", ++all[2].second.dimension;
  all[3].first = "seed", ++all[3].second.seed_low;
  all[4].first = "seed's upper half", ++all[4].second.seed_high;
  return all;
}

/// How far from even two numbers fill the unit square, in standard deviations (chi-square of 16 x 16 cells, by Wilson
/// and Hilferty 1931).
class Cells {
 public:
  void add(double x, double y) {
    ++counts_[std::size_t(x * 16) * 16 + std::size_t(y * 16)];
    ++total_;
  }
  double deviations() const {
    double chi_square = 0;
    for (double const count : counts_) chi_square += (count - total_ / 256) * (count - total_ / 256) / (total_ / 256);
    double const spread = 2 / (9 * 255.0);
    return (std::cbrt(chi_square / 255) - (1 - spread)) / std::sqrt(spread);
  }

 private:
  std::array<double, 256> counts_{};
  double total_ = 0;
};

}  // namespace

TEST_CASE("Sobol's points are his, before they are scrambled", "[kernel][sobol]") {
  // Joe and Kuo, "Constructing Sobol sequences with better two-dimensional projections", 2008, in the order of numbers.
  std::vector<double> const first{0, 1. / 2, 1. / 4, 3. / 4, 1. / 8, 5. / 8, 3. / 8, 7. / 8, 1. / 16};
  std::vector<double> const second{0, 1. / 2, 3. / 4, 1. / 4, 5. / 8, 1. / 8, 3. / 8, 7. / 8, 15. / 16};
  for (uint i = 0; i < first.size(); ++i) {
    CHECK(device::unit_real(device::reverse_bits(i)) == float(first[i]));
    CHECK(device::unit_real(device::reverse_bits(device::sobol_second_reversed(i))) == float(second[i]));
  }
  // All 32 columns, by the recurrence of direction numbers for the polynomial x + 1: v = v' ^ v' >> 1.
  uint direction = 0x80000000u;
  for (uint bit = 0; bit < 32; ++bit, direction ^= direction >> 1) {
    CHECK(device::reverse_bits(device::sobol_second_reversed(1u << bit)) == direction);
  }
}

TEST_CASE("each first 2^k points fill every elementary interval once", "[kernel][sobol]") {
  Random random(97);
  for (int trial = 0; trial < 30; ++trial) {
    Key const key = random_key(random);
    for (uint k = 0; k <= 10; ++k) {
      for (uint part = 0; part < 3; ++part) {  // of the blocks of so many, too
        for (uint columns_log = 0; columns_log <= k; ++columns_log) {
          uint const columns = 1u << columns_log, rows = 1u << (k - columns_log);
          std::vector<char> is_filled(std::size_t(1) << k);
          for (uint i = 0; i < 1u << k; ++i) {
            SobolPoint const p = point_of(key, (part << k) + i);
            is_filled[std::size_t(p.x * float(columns)) * rows + std::size_t(p.y * float(rows))] = 1;
          }
          INFO("trial " << trial << ", 2^" << k << " points, " << columns << " columns");
          if (std::count(is_filled.begin(), is_filled.end(), 1) != 1 << k) FAIL("an interval is empty");
        }
      }
    }
  }
}

TEST_CASE("points lie in the unit square, everywhere alike", "[kernel][sobol][statistics]") {
  Random random(98);
  Cells cells;
  for (int i = 0; i < 100000; ++i) {
    SobolPoint const p = point_of(random_key(random), uint(random.index(1ull << 32)));
    if (!(p.x >= 0 && p.x < 1 && p.y >= 0 && p.y < 1)) FAIL("outside");
    cells.add(p.x, p.y);
  }
  CHECK(cells.deviations() < 4);
}

TEST_CASE("points of other pixels, dimensions and seeds know nothing of each other", "[kernel][sobol][statistics]") {
  Random random(99);
  for (std::size_t which = 0; which < 5; ++which) {
    for (uint const sample : {0u, 1u, 5u}) {
      Cells xx, xy, yy;
      std::string name;
      for (int i = 0; i < 60000; ++i) {
        // Small numbers, in a row: those that pictures have.
        Key const key{uint(i % 256), uint(i / 256), uint(random.index(16)), uint(random.index(3))};
        auto const [what, neighbour] = neighbours(key)[which];
        SobolPoint const a = point_of(key, sample), b = point_of(neighbour, sample);
        xx.add(a.x, b.x);
        xy.add(a.x, b.y);
        yy.add(a.y, b.y);
        name = what;
      }
      INFO("next " << name << ", sample " << sample);
      CHECK(xx.deviations() < 4);
      CHECK(xy.deviations() < 4);
      CHECK(yy.deviations() < 4);
    }
  }
}

TEST_CASE("sequences of neighbours are not in step", "[kernel][sobol][statistics]") {
  Random random(100);
  constexpr uint count = 64;
  constexpr int trials = 2000;
  for (std::size_t which = 0; which < 5; ++which) {
    double sum = 0, squares = 0;
    for (int trial = 0; trial < trials; ++trial) {
      Key const key{uint(trial % 50), uint(trial / 50), uint(random.index(16)), 0};
      Key const neighbour = neighbours(key)[which].second;
      double correlation = 0;
      for (uint i = 0; i < count; ++i) {
        correlation += (double(point_of(key, i).x) - 0.5) * (double(point_of(neighbour, i).x) - 0.5) * 12 / count;
      }
      sum += correlation;
      squares += correlation * correlation;
    }
    INFO("neighbour " << which);
    double const variance = squares / trials;
    CHECK(std::abs(sum / trials) < 4 * std::sqrt(variance / trials));
    CHECK(variance < 4.0 / count);  // of independent numbers: 1 / count; points of a pair lie in other halves
  }
}

TEST_CASE("points are the same on host and device, one by one and sixteen at once", "[kernel][sobol][lanes]") {
  NEEDS_OPENCL_DEVICE();
  Random random(101);
  std::size_t const count = (scaled_count(4096) + 15) / 16 * 16;
  std::vector<std::array<uint, 4>> keys;
  for (std::size_t i = 0; i < count; ++i) {
    Key const key = random_key(random);
    keys.push_back({key.pixel_x, key.pixel_y, key.dimension, 0});
  }
  for (int const lanes : {1, 16}) {
    ProbeProgram const program("sobol.cl", fmt::format("-D LANES={}", lanes));
    for (uint const sample : {0u, 1u, 77u, 1u << 20, 0xffffffffu}) {
      uint const low = 12345u * sample, high = sample;
      std::vector<std::array<float, 2>> found(count), expected(count);
      program.run("probe_sobol", count / std::size_t(lanes),
                  {in(keys), value(sample), value(low), value(high), out(found)});
      for (std::size_t i = 0; i < count; ++i) {
        SobolPoint const p = device::sobol_point(keys[i][0], keys[i][1], keys[i][2], sample, low, high);
        expected[i] = {p.x, p.y};
      }
      CHECK(std::memcmp(found.data(), expected.data(), count * sizeof(found[0])) == 0);
    }
  }
}
