#include "io/obj/packed_pictures.hpp"

#include <algorithm>
#include <array>

namespace lichtraum::obj {
namespace {

/// The pixel of `picture` that is at (x, y) of a picture of size width x height.
std::uint8_t const* pixel_at(TextureImage const& picture, int x, int y, int width, int height) {
  auto const nearest = [](int place, int count, int of) { return int(std::int64_t(2 * place + 1) * of / (2 * count)); };
  auto const row = std::size_t(nearest(y, height, picture.height));
  auto const column = std::size_t(nearest(x, width, picture.width));
  return &picture.rgba[4 * (row * std::size_t(picture.width) + column)];
}

/// By Rec. 709's weights, in 256ths.
std::uint8_t brightness_of(std::uint8_t const* pixel) {
  return std::uint8_t((54 * pixel[0] + 183 * pixel[1] + 19 * pixel[2]) / 256);
}

bool has_alpha(TextureImage const& picture) {
  for (std::size_t i = 3; i < picture.rgba.size(); i += 4) {
    if (picture.rgba[i] != 255) return true;
  }
  return false;
}

PackedPictures::Picture packed(TextureImage const& picture, Channel channel, TextureImage const& source) {
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
      pixel[std::size_t(channel)] = is_in_alpha ? number[3] : brightness_of(number);
      result->rgba.insert(result->rgba.end(), pixel.begin(), pixel.end());
    }
  }
  return result;
}

}  // namespace

PackedPictures::Picture PackedPictures::with_channel(Picture const& picture, Channel channel, Picture const& source) {
  if (!source) return picture;
  auto const [place, is_new] = made_.try_emplace({picture, channel, source}, picture);
  if (!is_new) return place->second;
  TextureImage const white{"", 1, 1, {255, 255, 255, 255}};
  TextureImage const& others = picture ? *picture : white;
  std::size_t const bytes =
      4 * std::size_t(std::max(others.width, source->width)) * std::size_t(std::max(others.height, source->height));
  if (bytes > max_bytes - bytes_) {
    is_full_ = true;
    return picture;
  }
  bytes_ += bytes;
  return place->second = packed(others, channel, *source);
}

}  // namespace lichtraum::obj
