#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "accel/half_area.hpp"
#include "accel/lane_bounds.hpp"

namespace lichtraum {

inline constexpr std::size_t bin_count = 16;
/// CPUs test a ray against so many triangles at once: a whole leaf costs what a part of it does.
inline constexpr int max_leaf_size = 4;

/// Where the centres of a range fall.
class Binning {
 public:
  explicit Binning(LaneBounds const& centers) {
    for (int axis = 0; axis < 3; ++axis) {
      float const width = centers.max[axis] - centers.min[axis];
      // A little less than all bins: more than any rounding adds, so that the last centre falls into the last bin.
      float const scale = float(bin_count) * (1 - 1e-6f) / width;
      if (!(width > 0 && std::isfinite(width) && std::isfinite(scale))) continue;  // all in the first bin
      min_[axis] = centers.min[axis];
      scale_[axis] = scale;
    }
  }
  /// On all axes.
  IntLanes bins_of(LaneBounds const& bounds) const {
    return __builtin_convertvector((bounds.center() - min_) * scale_, IntLanes);
  }
  /// On all axes: all bits where the bin is below `bin`.
  IntLanes are_below(Lanes center, int bin) const { return (center - min_) * scale_ < float(bin) + Lanes{}; }
  /// Where bin `bin` of an axis begins.
  float position(int axis, int bin) const { return min_[axis] + float(bin) / scale_[axis]; }

 private:
  Lanes min_{};
  Lanes scale_{};
};

/// A way to divide a range in two parts that are not empty.
struct Split {
  int axis = 0;
  int bin = 0;  ///< bins below it go left
  /// Of the surface area heuristic: the sum over both sides of area times leaves. Infinite: nothing separates anything.
  float cost = std::numeric_limits<float>::infinity();
};

/// How many primitives have their centres in each bin of each axis, and what those enclose.
class Bins {
 public:
  void add(std::span<BuildPrimitive const> primitives, Binning const& binning) {
    if (primitives.size() < 32) {
      for (BuildPrimitive const& primitive : primitives) add(primitive, binning);
      return;
    }
    // Neighbours often fall into one bin, and would wait for each other.
    Bins second;
    std::size_t i = 0;
    for (; i + 1 < primitives.size(); i += 2) {
      add(primitives[i], binning);
      second.add(primitives[i + 1], binning);
    }
    if (i < primitives.size()) add(primitives[i], binning);
    add(second);
  }
  void add(Bins const& other) {
    for (std::size_t i = 0; i < bin_count; ++i) bins_[i].add(other.bins_[i]);
  }

  /// Of the planes between bins. Looks at all three axes at once: one lane each.
  Split best_split() const {
    std::array<Lanes, bin_count> cost_from_right;  // of bins [i, end) on one side
    Bin side;
    for (std::size_t i = bin_count; i-- > 1;) {
      side.add(bins_[i]);
      cost_from_right[i] = side.half_areas() * side.leaves();
    }
    IntLanes const all = side.count + bins_[0].count;
    side = {};
    Lanes best_cost = Lanes{} + std::numeric_limits<float>::infinity();
    IntLanes best_bin{};
    for (std::size_t i = 1; i < bin_count; ++i) {
      side.add(bins_[i - 1]);
      Lanes const cost = side.half_areas() * side.leaves() + cost_from_right[i];  // NaN where a side is empty
      IntLanes const is_better = (side.count > 0) & (side.count < all) & (cost < best_cost);
      best_cost = is_better ? cost : best_cost;
      best_bin = is_better ? IntLanes{} + int(i) : best_bin;
    }
    Split best;
    for (int axis = 0; axis < 3; ++axis) {
      if (best_cost[axis] < best.cost) best = {axis, best_bin[axis], best_cost[axis]};
    }
    return best;
  }

  /// Bounds of what is in the bins [begin, end) of an axis.
  LaneBounds enclose(int axis, int begin, int end) const {
    LaneBounds bounds;
    for (int i = begin; i < end; ++i) bounds.add(bins_[std::size_t(i)].bounds[std::size_t(axis)]);
    return bounds;
  }

 private:
  /// One bin of each axis.
  struct Bin {
    std::array<LaneBounds, 3> bounds;
    IntLanes count{};

    void add(Bin const& other) {
      for (std::size_t axis = 0; axis < 3; ++axis) bounds[axis].add(other.bounds[axis]);
      count += other.count;
    }
    /// Half the surface of the bounds of each axis.
    Lanes half_areas() const {
      auto const& [of_x, of_y, of_z] = bounds;
      Lanes const a = of_x.max - of_x.min, b = of_y.max - of_y.min, c = of_z.max - of_z.min;
      Lanes const xy_of_a_b = __builtin_shufflevector(a, b, 0, 4, 1, 5);
      Lanes const x = __builtin_shufflevector(xy_of_a_b, c, 0, 1, 4, 4);
      Lanes const y = __builtin_shufflevector(xy_of_a_b, c, 2, 3, 5, 5);
      Lanes const z = __builtin_shufflevector(__builtin_shufflevector(a, b, 2, 6, 2, 6), c, 0, 1, 6, 6);
      return half_area(x, y, z);
    }
    /// That so many primitives fill.
    Lanes leaves() const {
      static_assert(max_leaf_size == 4);
      return __builtin_convertvector((count + 3) >> 2, Lanes);
    }
  };

  void add(BuildPrimitive const& primitive, Binning const& binning) {
    LaneBounds const lanes(primitive);
    IntLanes const bins = binning.bins_of(lanes);
    for (int axis = 0; axis < 3; ++axis) {
      Bin& bin = bins_[std::size_t(bins[axis])];
      bin.bounds[std::size_t(axis)].add(lanes);
      ++bin.count[axis];
    }
  }

  std::array<Bin, bin_count> bins_;
};

}  // namespace lichtraum
