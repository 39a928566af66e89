#include "io/lines.hpp"

#include "core/float3.hpp"

namespace lichtraum {

std::vector<std::uint32_t> to_line_list(std::vector<std::uint32_t> indices, int mode) {
  constexpr int loop = 2;
  constexpr int strip = 3;
  if (mode != loop && mode != strip) {
    indices.resize(indices.size() / 2 * 2);
    return indices;
  }
  std::vector<std::uint32_t> list;
  if (indices.size() < 2) return list;
  for (std::size_t i = 0; i + 1 < indices.size(); ++i) list.insert(list.end(), {indices[i], indices[i + 1]});
  if (mode == loop) list.insert(list.end(), {indices.back(), indices.front()});
  return list;
}

LineFaults remove_faulty_lines(MeshGeometry& geometry) {
  auto const& positions = geometry.positions;
  auto const is_there = [&](std::uint32_t end) { return end < positions.size(); };
  LineFaults faults;
  std::vector<std::uint32_t>& lines = geometry.lines;
  std::size_t kept = 0;
  for (std::size_t i = 0; i + 1 < lines.size(); i += 2) {
    std::uint32_t const begin = lines[i], end = lines[i + 1];
    if (!is_there(begin) || !is_there(end)) {
      ++faults.out_of_range;
    } else if (!is_finite(positions[begin]) || !is_finite(positions[end])) {
      ++faults.non_finite;
    } else {
      lines[kept++] = begin;
      lines[kept++] = end;
    }
  }
  lines.resize(kept);
  return faults;
}

}  // namespace lichtraum
