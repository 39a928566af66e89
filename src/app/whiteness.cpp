#include "app/whiteness.hpp"

#include <algorithm>

namespace lichtraum::app {
namespace {

/// What all channels of a white pixel exceed, with 8 bits each. Without a tone map, white itself is stored as it is; a
/// tone map has nothing beyond it.
float limit_of(Development const& development) {
  return (development.tone_map == ToneMap::none ? 255.5f : 254.5f) / 255;
}

std::uint64_t count_white(Image const& pixels, Development const& development) {
  float const limit = limit_of(development);
  std::uint64_t count = 0;
  for (std::size_t i = 0; i + 2 < pixels.data().size(); i += 3) {
    float const* const color = pixels.data().data() + i;
    count += color[0] > limit && color[1] > limit && color[2] > limit;
  }
  return count;
}

bool is_white(Rgb const& radiance, Development const& development) {
  Film film = Film::of_samples({0, 0, 1, 1}, {FilmPlane::radiance}, {0, 1});
  for (int c = 0; c < 3; ++c) film.floats(FilmPlane::radiance)[std::size_t(c)] = float(radiance[c]);
  return count_white(develop(std::move(film), development), development) > 0;
}

}  // namespace

void Whiteness::add(Image const& pixels, Development const& development) {
  pixels_ += pixels.data().size() / 3;
  white_ += count_white(pixels, development);
}

double Whiteness::share(double seen, Background const& background, Development const& development) const {
  bool const is_view = background.kind == Background::Kind::environment;
  double const all = double(pixels_), shown = is_view ? all : all * seen;
  constexpr double least_seen = 0.01;  // else it is a few points of light
  if (shown < least_seen * all) return 0;
  bool const is_before_white =
      !is_view && (is_white(background.top, development) || is_white(background.bottom, development));
  double const white = double(white_) - (is_before_white ? all - shown : 0);
  return shown > 0 ? std::clamp(white / shown, 0.0, 1.0) : 0;
}

}  // namespace lichtraum::app
