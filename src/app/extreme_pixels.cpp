#include "app/extreme_pixels.hpp"

#include <algorithm>
#include <vector>

namespace lichtraum::app {
namespace {

/// What all channels of a white pixel exceed, with 8 bits each. Without a tone map, white itself is stored as it is; a
/// tone map has nothing beyond it.
float white_limit(Development const& development) {
  return (development.tone_map == ToneMap::none ? 255.5f : 254.5f) / 255;
}

constexpr float black_limit = 2.5f / 255;

}  // namespace

ExtremePixels::Counts ExtremePixels::count(Image const& pixels, Development const& development) {
  float const white = white_limit(development);
  Counts counts;
  std::vector<float> const& data = pixels.data();
  for (std::size_t i = 0; i + 2 < data.size(); i += 3) {
    float const r = data[i], g = data[i + 1], b = data[i + 2];
    if (r >= black_limit && r <= white) continue;  // as most are: in sequences the time counts
    counts.white += r > white && g > white && b > white;
    counts.black += r < black_limit && g < black_limit && b < black_limit;
  }
  return counts;
}

ExtremePixels::Counts ExtremePixels::count(Rgb const& radiance, Development const& development) {
  Film film = Film::of_samples({0, 0, 1, 1}, {FilmPlane::radiance}, {0, 1});
  for (int c = 0; c < 3; ++c) film.floats(FilmPlane::radiance)[std::size_t(c)] = float(radiance[c]);
  return count(develop(std::move(film), development), development);
}

void ExtremePixels::add(Image const& pixels, Development const& development) {
  pixels_ += pixels.data().size() / 3;
  Counts const counts = count(pixels, development);
  counts_.white += counts.white;
  counts_.black += counts.black;
}

double ExtremePixels::white_share(double seen, Background const& background, Development const& development) const {
  return share(&Counts::white, seen, background, development);
}

double ExtremePixels::black_share(double seen, Background const& background, Development const& development) const {
  return share(&Counts::black, seen, background, development);
}

double ExtremePixels::share(std::uint64_t Counts::*which, double seen, Background const& background,
                            Development const& development) const {
  bool const is_view = background.kind == Background::Kind::environment;
  double const all = double(pixels_), shown = is_view ? all : all * seen;
  constexpr double least_seen = 0.01;  // else it is a few points of light
  if (shown < least_seen * all) return 0;
  bool const is_before_such =
      !is_view && (count(background.top, development).*which > 0 || count(background.bottom, development).*which > 0);
  double const such = double(counts_.*which) - (is_before_such ? all - shown : 0);
  return shown > 0 ? std::clamp(such / shown, 0.0, 1.0) : 0;
}

}  // namespace lichtraum::app
