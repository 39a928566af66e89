#include "view/marking.hpp"

#include <algorithm>
#include <array>

namespace lichtraum::view {

std::vector<unsigned char> outline_pixels(Film const& film, ObjectTree::Objects const& objects) {
  using Rgba = std::array<unsigned char, 4>;
  constexpr Rgba line{255, 160, 30, 255}, edge{20, 10, 0, 200};
  auto const [width, height] = film.size();
  auto const is_marked = [&](int x, int y) {
    std::uint64_t const object = film.number(FilmPlane::object, std::clamp(x, 0, film.size().width - 1),
                                             std::clamp(y, 0, film.size().height - 1));
    return object >= objects.first && object < objects.first + objects.count;
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
