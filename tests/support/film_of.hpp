#pragma once

#include <algorithm>

#include "lichtraum/film.hpp"

namespace lichtraum::test {

/// A film of one sample whose radiance is that image.
inline Film film_of(Image const& image) {
  Film film(whole_picture(image.size()), {FilmPlane::radiance});
  std::ranges::copy(image.data(), film.floats(FilmPlane::radiance).begin());
  film.set_end(1);
  return film;
}

}  // namespace lichtraum::test
