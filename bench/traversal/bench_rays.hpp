#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "shared/frame.h"

namespace lichtraum::bench {

struct TriangleMesh {
  std::vector<std::array<float, 3>> positions;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

struct RayHit {
  static constexpr std::uint32_t none = 0xffffffffu;
  float t = 0;  ///< in units of the ray's direction; infinity: nothing was hit
  std::uint32_t triangle = none;
  std::uint32_t instance = none;  ///< that was entered; none: the triangle is the world's
};

/// The rays of a picture: one through the centre of each pixel, or of each cell of a grid in it.
struct PrimaryRays {
  device::ProjectiveCamera camera;
  int width = 0;   ///< rays per row
  int height = 0;  ///< rows
  float pixels_per_ray = 1;
  std::size_t size() const { return std::size_t(width) * std::size_t(height); }
};

/// From each point to one light; points with w == 0 send none. In rows of a picture.
struct ShadowRays {
  std::vector<device::float4> points;
  device::float4 light;
  int width = 0;
  int height = 0;
  std::size_t size() const { return points.size(); }
};

/// With nothing in common but what the surfaces that they leave have; a multiple of rays_per_item.
struct FreeRays {
  static constexpr std::size_t rays_per_item = 64;
  std::vector<device::float4> origins;
  std::vector<device::float4> directions;                ///< of length 1; zero: no ray
  float t_max = std::numeric_limits<float>::infinity();  ///< for any-hit; the closest hit is looked for everywhere
  std::size_t count = 0;                                 ///< of rays that there are
  std::size_t size() const { return origins.size(); }
};

}  // namespace lichtraum::bench
