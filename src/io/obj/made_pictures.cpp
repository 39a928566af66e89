#include "io/obj/made_pictures.hpp"

#include <algorithm>
#include <array>

#include "io/obj/brightness.hpp"
#include "io/obj/bump_map.hpp"

namespace lichtraum::obj {
namespace {

/// The pixel of `picture` that is at (x, y) of a picture of size width x height.
std::uint8_t const* pixel_at(TextureImage const& picture, int x, int y, int width, int height) {
  auto const nearest = [](int place, int count, int of) { return int(std::int64_t(2 * place + 1) * of / (2 * count)); };
  auto const row = std::size_t(nearest(y, height, picture.height));
  auto const column = std::size_t(nearest(x, width, picture.width));
  return &picture.rgba[4 * (row * std::size_t(picture.width) + column)];
}

bool has_alpha(TextureImage const& picture) {
  for (std::size_t i = 3; i < picture.rgba.size(); i += 4) {
    if (picture.rgba[i] != 255) return true;
  }
  return false;
}

MadePictures::Picture packed(TextureImage const& picture, Channel channel, TextureImage const& source) {
  auto result = std::make_shared<TextureImage>();
  result->name = picture.name.empty() ? source.name : picture.name;
  result->width = std::max(picture.width, source.width);
  result->height = std::max(picture.height, source.height);
  result->rgba.reserve(4 * std::size_t(result->width) * std::size_t(result->height));
  bool const is_in_alpha = channel == Channel::alpha && has_alpha(source);
  for (int y = 0; y < result->height; ++y) {
    for (int x = 0; x < result->width; ++x) {
      std::array<std::uint8_t, 4> pixel;
      std::copy_n(pixel_at(picture, x, y, result->width, result->height), 4, pixel.begin());
      std::uint8_t const* const number = pixel_at(source, x, y, result->width, result->height);
      pixel[std::size_t(channel)] = is_in_alpha ? number[3] : std::uint8_t(brightness_of(number));
      result->rgba.insert(result->rgba.end(), pixel.begin(), pixel.end());
    }
  }
  return result;
}

}  // namespace

MadePictures::Picture MadePictures::with_channel(Picture const& picture, Channel channel, Picture const& source) {
  if (!source) return picture;
  auto const [place, is_new] = packed_.try_emplace({picture, channel, source}, picture);
  TextureImage const white{"", 1, 1, {255, 255, 255, 255}};
  TextureImage const& others = picture ? *picture : white;
  if (is_new && take(std::max(others.width, source->width), std::max(others.height, source->height))) {
    place->second = packed(others, channel, *source);
  }
  return place->second;
}

bool MadePictures::is_normal_map(Picture const& bump_map) {
  auto const [place, is_new] = are_normals_.try_emplace(bump_map);
  if (is_new) place->second = obj::is_normal_map(*bump_map);
  return place->second;
}

MadePictures::Picture MadePictures::normals_from(Picture const& heights, double multiplier, bool is_clamped) {
  auto const [place, is_new] = normals_.try_emplace({heights, multiplier, is_clamped});
  if (is_new && take(heights->width, heights->height)) {
    place->second = std::make_shared<TextureImage const>(normals_from_heights(*heights, multiplier, is_clamped));
  }
  return place->second;
}

bool MadePictures::take(int width, int height) {
  std::size_t const bytes = 4 * std::size_t(width) * std::size_t(height);
  if (bytes > max_bytes - bytes_) {
    is_full_ = true;
    return false;
  }
  bytes_ += bytes;
  return true;
}

}  // namespace lichtraum::obj
