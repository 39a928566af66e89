#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "accel/bvh.hpp"

namespace lichtraum {

/// x, y, z, and a fourth lane that holds anything.
using Lanes = float __attribute__((vector_size(16)));
using IntLanes = std::int32_t __attribute__((vector_size(16)));

/// Of a number and a NaN the first argument; so do the instructions for them.
inline Lanes min_of(Lanes a, Lanes b) { return b < a ? b : a; }
inline Lanes max_of(Lanes a, Lanes b) { return a < b ? b : a; }
/// Reads one float more than the three.
inline Lanes load(float const* three) {
  Lanes lanes;
  std::memcpy(&lanes, three, sizeof lanes);
  return lanes;
}

/// Bounds of a primitive, or around several, for loops over many: an instruction for all three axes.
struct LaneBounds {
  Lanes min = Lanes{} + DeviceBounds::infinity;
  Lanes max = Lanes{} - DeviceBounds::infinity;

  LaneBounds() = default;
  explicit LaneBounds(BuildPrimitive const& p) : min(load(&p.bounds.min.x)), max(load(&p.bounds.max.x)) {}

  void add(LaneBounds const& other) {
    min = min_of(min, other.min);
    max = max_of(max, other.max);
  }
  /// A point of NaN changes nothing.
  void add_point(Lanes point) {
    min = min_of(min, point);
    max = max_of(max, point);
  }
  Lanes center() const { return 0.5f * min + 0.5f * max; }
  DeviceBounds bounds() const { return {{min[0], min[1], min[2]}, {max[0], max[1], max[2]}}; }
};
// Where load reads beyond a primitive's bounds there is its reference.
static_assert(offsetof(BuildPrimitive, bounds) == 0 && sizeof(BuildPrimitive) >= sizeof(DeviceBounds) + sizeof(float));

}  // namespace lichtraum
