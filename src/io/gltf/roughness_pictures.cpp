#include "io/gltf/roughness_pictures.hpp"

#include <algorithm>
#include <cmath>

namespace lichtraum::gltf {

RoughnessPictures::Roughness RoughnessPictures::roughness_from(Picture const& source, double glossiness) {
  auto const [place, is_new] = known_.try_emplace({source, glossiness});
  if (is_new) place->second = make(*source, glossiness);
  return place->second;
}

RoughnessPictures::Roughness RoughnessPictures::make(TextureImage const& source, double glossiness) {
  std::uint8_t least = 255, most = 0;
  double sum = 0;
  for (std::size_t i = 3; i < source.rgba.size(); i += 4) {
    least = std::min(least, source.rgba[i]);
    most = std::max(most, source.rgba[i]);
    sum += source.rgba[i];
  }
  // Pictures without alpha are common: these need no second one.
  if (glossiness == 0 || least >= most) return {1 - glossiness * most / 255, nullptr};
  if (!budget_.take_for_good(source.rgba.size())) {
    return {1 - glossiness * sum / (255 * double(source.rgba.size() / 4)), nullptr, true};
  }
  auto picture = std::make_shared<TextureImage>();
  picture->name = source.name;
  picture->width = source.width;
  picture->height = source.height;
  picture->rgba.resize(source.rgba.size(), 255);
  for (std::size_t i = 0; i < source.rgba.size(); i += 4) {
    picture->rgba[i + 1] = std::uint8_t(std::lround(255 - glossiness * source.rgba[i + 3]));
  }
  return {1, std::move(picture)};
}

}  // namespace lichtraum::gltf
