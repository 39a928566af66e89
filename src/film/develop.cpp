#include "film/develop.hpp"

#include <stdexcept>

#include "core/elementary.hpp"

namespace lichtraum {

device::DevelopParameters develop_parameters(Development const& development, int sample_count) {
  if (development.tone_map == ToneMap::automatic) throw std::invalid_argument("no scene says which tone map to take");
  return {float(sample_count), float(pow_of(2.0, development.exposure_ev)),
          development.tone_map == ToneMap::reinhard ? TONE_MAP_REINHARD : TONE_MAP_NONE,
          development.transfer == Transfer::srgb ? TRANSFER_SRGB : TRANSFER_LINEAR};
}

void develop_sums(std::vector<float>& radiance, std::vector<float> const& alpha,
                  device::DevelopParameters const& parameters) {
  if (alpha.empty()) {
    for (float& value : radiance) value = device::develop_mean(value, parameters);
    return;
  }
  for (std::size_t i = 0; i < radiance.size(); ++i) {
    radiance[i] = device::develop_straight(radiance[i], alpha[i / 3], parameters);
  }
}

Image develop(Film film, Development const& development) {
  return develop_film(std::move(film), development, develop_sums);
}

}  // namespace lichtraum
