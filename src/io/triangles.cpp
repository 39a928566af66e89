#include "io/triangles.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/float3.hpp"

namespace lichtraum {

std::vector<std::uint32_t> to_triangle_list(std::vector<std::uint32_t> indices, int mode) {
  constexpr int strip = 5;
  constexpr int fan = 6;
  if (mode != strip && mode != fan) {
    indices.resize(indices.size() / 3 * 3);
    return indices;
  }
  std::vector<std::uint32_t> list;
  for (std::size_t i = 0; i + 2 < indices.size(); ++i) {
    std::uint32_t const a = indices[i], b = indices[i + 1], c = indices[i + 2];
    if (mode == fan) {
      list.insert(list.end(), {b, c, indices[0]});
    } else if (i % 2 == 0) {
      list.insert(list.end(), {a, b, c});
    } else {
      list.insert(list.end(), {a, c, b});
    }
  }
  return list;
}

TriangleFaults remove_faulty_triangles(MeshGeometry& geometry) {
  auto const& positions = geometry.positions;
  std::size_t const count = positions.size();
  std::uint32_t largest = 0;
  for (std::uint32_t const i : geometry.indices) largest = std::max(largest, i);
  float sum = 0;  // 0 unless there is a NaN or an infinity
  for (Float3 const& p : positions) sum += p[0] * 0 + p[1] * 0 + p[2] * 0;
  if (largest < count && sum == 0) return {};

  TriangleFaults faults;
  std::size_t kept = 0;
  auto& indices = geometry.indices;
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
    std::uint32_t const corners[] = {indices[i], indices[i + 1], indices[i + 2]};
    if (std::any_of(std::begin(corners), std::end(corners), [&](std::uint32_t c) { return c >= count; })) {
      ++faults.out_of_range;
    } else if (!std::all_of(std::begin(corners), std::end(corners), [&](auto c) { return is_finite(positions[c]); })) {
      ++faults.non_finite;
    } else {
      std::copy(std::begin(corners), std::end(corners), indices.begin() + std::ptrdiff_t(kept));
      kept += 3;
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
