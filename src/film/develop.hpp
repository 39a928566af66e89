#pragma once

#include <algorithm>
#include <stdexcept>

#include "lichtraum/film.hpp"
#include "shared/develop.h"

namespace lichtraum {

/// Throws std::invalid_argument for `automatic`.
device::DevelopParameters develop_parameters(Development const& development, int sample_count);

/// Whether developing only divides by the number of samples, and scales: no tone map, no transfer function.
bool is_mean(device::DevelopParameters const& parameters);

/// Sums of radiance become what a picture stores, where they are. `alpha`: sums as well, or nothing.
void develop_sums(std::vector<float>& radiance, std::vector<float> const& alpha,
                  device::DevelopParameters const& parameters);

/// The picture of a film whose sums `develop` (as above) develops.
template <class DevelopSums>
Image develop_film(Film film, Development const& development, DevelopSums const& develop) {
  if (!film.planes().has(FilmPlane::radiance) || film.is_empty()) {
    throw std::invalid_argument("only a film with samples of radiance can be developed");
  }
  auto const parameters = develop_parameters(development, film.samples().count());
  auto radiance = film.take_sums(FilmPlane::radiance);
  auto alpha = film.planes().has(FilmPlane::alpha) ? film.take_sums(FilmPlane::alpha) : std::vector<float>();
  develop(radiance, alpha, parameters);
  for (float& value : alpha) value = std::clamp(value / parameters.sample_count, 0.0f, 1.0f);
  Image image(film.size(), std::move(radiance));
  image.alpha() = std::move(alpha);
  return image;
}

}  // namespace lichtraum
