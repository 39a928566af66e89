#include "view/marking.hpp"

#include <algorithm>
#include <array>

namespace lichtraum::view {

std::vector<unsigned char> outline_pixels(Image const& object_ids, ObjectTree::Objects const& objects) {
  using Rgba = std::array<unsigned char, 4>;
  constexpr Rgba line{255, 160, 30, 255}, edge{20, 10, 0, 200};
  int const width = object_ids.width(), height = object_ids.height();
  auto const first = float(objects.first), end = float(objects.first + objects.count);
  auto const is_marked = [&](int x, int y) {
    float const id = *object_ids.pixel(std::clamp(x, 0, width - 1), std::clamp(y, 0, height - 1));
    return id >= first && id < end;
  };
  std::vector<unsigned char> pixels(4 * std::size_t(width) * std::size_t(height));
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      bool const inside = is_marked(x, y);
      bool differs = false;
      for (auto const& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
        differs = differs || is_marked(x + dx, y + dy) != inside;
      }
      if (!differs) continue;
      Rgba const& color = inside ? line : edge;
      std::copy(color.begin(), color.end(), pixels.begin() + 4 * (std::ptrdiff_t(y) * width + x));
    }
  }
  return pixels;
}

}  // namespace lichtraum::view
