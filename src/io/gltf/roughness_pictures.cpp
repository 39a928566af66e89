#include "io/gltf/roughness_pictures.hpp"

#include <algorithm>
#include <cmath>

namespace lichtraum::gltf {

RoughnessPictures::Roughness RoughnessPictures::roughness_from(Picture const& source, double glossiness) {
  auto const [place, is_new] = known_.try_emplace({source, glossiness});
  if (is_new) place->second = make(source, glossiness);
  return place->second;
}

RoughnessPictures::Alpha const& RoughnessPictures::alpha_of(Picture const& source) {
  auto const [place, is_new] = alphas_.try_emplace(source);
  if (!is_new) return place->second;
  Alpha& alpha = place->second;
  double sum = 0;
  for (std::size_t i = 3; i < source->rgba.size(); i += 4) {
    alpha.least = std::min(alpha.least, source->rgba[i]);
    alpha.most = std::max(alpha.most, source->rgba[i]);
    sum += source->rgba[i];
  }
  alpha.mean = sum / double(source->rgba.size() / 4);
  return alpha;
}

RoughnessPictures::Roughness RoughnessPictures::make(Picture const& source, double glossiness) {
  auto const [least, most, mean] = alpha_of(source);
  // Pictures without alpha are common: these need no second one.
  if (glossiness == 0 || least >= most) return {1 - glossiness * most / 255, nullptr};
  if (!budget_.take_for_good(source->rgba.size())) return {1 - glossiness * mean / 255, nullptr, true};
  auto picture = std::make_shared<TextureImage>();
  picture->name = source->name;
  picture->width = source->width;
  picture->height = source->height;
  picture->rgba.resize(source->rgba.size(), 255);
  for (std::size_t i = 0; i < source->rgba.size(); i += 4) {
    picture->rgba[i + 1] = std::uint8_t(std::lround(255 - glossiness * source->rgba[i + 3]));
  }
  return {1, std::move(picture)};
}

}  // namespace lichtraum::gltf
