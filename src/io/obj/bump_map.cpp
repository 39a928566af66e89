#include "io/obj/bump_map.hpp"

#include <algorithm>
#include <cmath>

#include "io/obj/brightness.hpp"

namespace lichtraum::obj {
namespace {

constexpr double height_of_white = 0.02;    // of the picture's longer side
constexpr double largest_multiplier = 1e4;  // upright walls; anything beyond it changes nothing

class Heights {
 public:
  Heights(TextureImage const& picture, bool is_clamped) : picture_(picture), is_clamped_(is_clamped) {}

  /// From 0, black, to 255.
  int at(int x, int y) const {
    auto const column = std::size_t(inside(x, picture_.width));
    auto const row = std::size_t(inside(y, picture_.height));
    return brightness_of(&picture_.rgba[4 * (row * std::size_t(picture_.width) + column)]);
  }

 private:
  int inside(int i, int size) const { return is_clamped_ ? std::clamp(i, 0, size - 1) : (i + size) % size; }

  TextureImage const& picture_;
  bool is_clamped_;
};

std::uint8_t byte_of(double component) { return std::uint8_t(std::lround(127.5 + 127.5 * component)); }

}  // namespace

bool is_normal_map(TextureImage const& picture) {
  constexpr std::int64_t margin = 32;  // of 255; it is 127 where all normals are upright
  std::int64_t red = 0, green = 0, blue = 0;
  for (std::size_t i = 0; i < picture.rgba.size(); i += 4) {
    red += picture.rgba[i];
    green += picture.rgba[i + 1];
    blue += picture.rgba[i + 2];
  }
  return blue - std::max(red, green) > margin * std::int64_t(picture.rgba.size() / 4);
}

TextureImage normals_from_heights(TextureImage const& picture, double multiplier, bool is_clamped) {
  Heights const heights(picture, is_clamped);
  // Sobel's sums are eight times the difference from one pixel to the next.
  double const pixels_per_sum = std::clamp(multiplier, -largest_multiplier, largest_multiplier) * height_of_white *
                                std::max(picture.width, picture.height) / (8 * 255);
  TextureImage result{picture.name, picture.width, picture.height, {}};
  result.rgba.reserve(picture.rgba.size());
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      auto const column = [&](int dx) {
        return heights.at(x + dx, y - 1) + 2 * heights.at(x + dx, y) + heights.at(x + dx, y + 1);
      };
      auto const row = [&](int dy) {
        return heights.at(x - 1, y + dy) + 2 * heights.at(x, y + dy) + heights.at(x + 1, y + dy);
      };
      double const to_the_right = pixels_per_sum * (column(1) - column(-1));
      double const upwards = pixels_per_sum * (row(-1) - row(1));
      double const length = std::sqrt(to_the_right * to_the_right + upwards * upwards + 1);
      std::uint8_t const normal[] = {byte_of(-to_the_right / length), byte_of(-upwards / length), byte_of(1 / length),
                                     255};
      result.rgba.insert(result.rgba.end(), std::begin(normal), std::end(normal));
    }
  }
  return result;
}

}  // namespace lichtraum::obj
