#include "accel/bins.hpp"

#include <algorithm>
#include <random>

#include "support/catch.hpp"

using namespace lichtraum;

namespace {

/// The sum over both sides of half the surface times leaves; infinite where a side is empty.
double cost_of(std::vector<BuildPrimitive> const& primitives, Binning const& binning, int axis, int bin) {
  LaneBounds sides[2];
  int counts[2] = {};
  for (BuildPrimitive const& primitive : primitives) {
    LaneBounds const bounds(primitive);
    int const side = binning.bins_of(bounds)[axis] < bin ? 0 : 1;
    sides[side].add(bounds);
    ++counts[side];
  }
  if (counts[0] == 0 || counts[1] == 0) return std::numeric_limits<double>::infinity();
  double sum = 0;
  for (int side : {0, 1}) {
    Lanes const size = sides[side].max - sides[side].min;
    sum += double(half_area(size[0], size[1], size[2])) * ((counts[side] + max_leaf_size - 1) / max_leaf_size);
  }
  return sum;
}

/// Flat or long as the factors have it, so that either axis is the best of some.
std::vector<BuildPrimitive> random_boxes(std::mt19937& random, std::size_t count) {
  std::uniform_real_distribution<float> coordinate(-1, 1), factor(0.1f, 10), size(0, 0.4f);
  Vec3 const factors(factor(random), factor(random), factor(random));
  std::vector<BuildPrimitive> boxes(count);
  for (BuildPrimitive& box : boxes) {
    for (int axis = 0; axis < 3; ++axis) {
      float const center = coordinate(random) * float(factors[axis]), half = size(random) * float(factors[axis]);
      box.bounds.min[axis] = center - half;
      box.bounds.max[axis] = center + half;
    }
  }
  return boxes;
}

}  // namespace

TEST_CASE("bins find the split of least cost on all three axes", "[unit][bvh]") {
  std::mt19937 random(5);
  int best_on[3] = {};
  for (std::size_t const count : {2u, 3u, 9u, 31u, 32u, 33u, 500u}) {
    for (int round = 0; round < 30; ++round) {
      auto const boxes = random_boxes(random, count);
      LaneBounds centers;
      for (BuildPrimitive const& box : boxes) centers.add_point(LaneBounds(box).center());
      Binning const binning(centers);
      Bins bins;
      bins.add(boxes, binning);
      Split const split = bins.best_split();
      double least = std::numeric_limits<double>::infinity();
      for (int axis = 0; axis < 3; ++axis) {
        for (int bin = 1; bin < int(bin_count); ++bin) least = std::min(least, cost_of(boxes, binning, axis, bin));
      }
      INFO(count << " boxes, axis " << split.axis << ", bin " << split.bin);
      CHECK(double(split.cost) == Approx(least).epsilon(1e-5));
      CHECK(cost_of(boxes, binning, split.axis, split.bin) == Approx(least).epsilon(1e-5));
      ++best_on[split.axis];
    }
  }
  for (int const times : best_on) CHECK(times > 20);
}
