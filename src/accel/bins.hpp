#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>

#include "accel/lane_bounds.hpp"

namespace lichtraum {

inline constexpr std::size_t bin_count = 16;

/// Where the centres of a range fall.
class Binning {
 public:
  explicit Binning(Bounds const& centers) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      float const width = centers.max[axis] - centers.min[axis];
      min_[axis] = centers.min[axis];
      // A little less than all bins, so that the last centre falls into the last bin.
      float const scale = float(bin_count) * (1 - 1e-6f) / width;
      scale_[axis] = width > 0 && std::isfinite(scale) ? scale : 0;
    }
  }
  /// Whether planes across this axis separate anything.
  bool separates(std::size_t axis) const { return scale_[axis] > 0; }
  std::size_t bin_of(Bounds const& bounds, std::size_t axis) const {
    return rounded((bounds.center(int(axis)) - min_[axis]) * scale_[axis]);
  }
  /// On all axes; in floats, not rounded yet.
  Lanes bins_of(LaneBounds const& bounds) const { return (bounds.center() - min_) * scale_; }
  static std::size_t rounded(float bin) { return std::min(std::size_t(bin), bin_count - 1); }

 private:
  Lanes min_{};
  Lanes scale_{};
};

/// How many primitives have their centres in each bin of each axis, and what those enclose.
struct Bins {
  std::array<std::array<LaneBounds, bin_count>, 3> bounds;
  std::array<std::array<std::uint32_t, bin_count>, 3> count{};

  void add(std::span<BuildPrimitive const> primitives, Binning const& binning) {
    for (BuildPrimitive const& primitive : primitives) {
      LaneBounds const lanes(primitive);
      Lanes const bins = binning.bins_of(lanes);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        std::size_t const bin = Binning::rounded(bins[axis]);
        bounds[axis][bin].add(lanes);
        ++count[axis][bin];
      }
    }
  }
  void add(Bins const& other) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (std::size_t bin = 0; bin < bin_count; ++bin) {
        bounds[axis][bin].add(other.bounds[axis][bin]);
        count[axis][bin] += other.count[axis][bin];
      }
    }
  }
};

}  // namespace lichtraum
