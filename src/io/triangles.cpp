#include "io/triangles.hpp"

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

}  // namespace lichtraum
