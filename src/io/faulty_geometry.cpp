#include "io/faulty_geometry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "core/float3.hpp"

namespace lichtraum {

GeometryFaults remove_faulty(std::vector<std::uint32_t>& indices, std::size_t corners,
                             std::vector<Float3> const& positions) {
  std::size_t const count = positions.size();
  std::uint32_t largest = 0;
  for (std::uint32_t const i : indices) largest = std::max(largest, i);
  float sum = 0;  // 0 unless there is a NaN or an infinity
  for (Float3 const& p : positions) sum += p[0] * 0 + p[1] * 0 + p[2] * 0;
  if (largest < count && sum == 0) return {};

  GeometryFaults faults;
  std::size_t kept = 0;
  for (std::size_t i = 0; i + corners <= indices.size(); i += corners) {
    std::span const group(indices.data() + i, corners);
    if (std::any_of(group.begin(), group.end(), [&](std::uint32_t c) { return c >= count; })) {
      ++faults.out_of_range;
    } else if (!std::all_of(group.begin(), group.end(), [&](std::uint32_t c) { return is_finite(positions[c]); })) {
      ++faults.non_finite;
    } else {
      std::copy(group.begin(), group.end(), indices.begin() + std::ptrdiff_t(kept));
      kept += corners;
    }
  }
  indices.resize(kept);
  return faults;
}

std::string left_out_message(std::size_t count, std::string_view what, std::string_view noun) {
  return count == 1 ? fmt::format("1 {} left out: it has {}", noun, what)
                    : fmt::format("{} {}s left out: they have {}", count, noun, what);
}

}  // namespace lichtraum
