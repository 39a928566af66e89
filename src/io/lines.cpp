#include "io/lines.hpp"

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

}  // namespace lichtraum
