#include <algorithm>
#include <cmath>
#include <limits>

#include "core/elementary.hpp"
#include "core/srgb.hpp"
#include "lichtraum/film.hpp"

namespace lichtraum {
namespace {

float logarithm(float x) { return float(log_of(double(x))); }

/// One colour channel for each of the plane's; of a plane of one channel, three of the same.
Image values_of(Film const& film, FilmPlane plane) {
  Image image(film.size());
  int const channels = int(info_of(plane).channels.size());
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      for (int c = 0; c < 3; ++c) image.pixel(x, y)[c] = film.value(plane, x, y, c % channels);
    }
  }
  return image;
}

Image show_colors(Image image, Transfer transfer) {
  if (transfer == Transfer::srgb) {
    for (float& value : image.data()) value = float(srgb_from_linear(double(value)));
  }
  return image;
}

/// Equal ratios look equally far apart: a floor that reaches to the horizon leaves the things on it their contrast.
Image show_depth(Image image) {
  float nearest = std::numeric_limits<float>::infinity(), farthest = 0;
  for (float const value : image.data()) {
    if (!std::isfinite(value)) continue;
    nearest = std::min(nearest, value);
    farthest = std::max(farthest, value);
  }
  constexpr float darkest = 0.1f;
  nearest = std::max(nearest, 1e-6f * farthest);
  float const scale = farthest > nearest ? (1 - darkest) / logarithm(farthest / nearest) : 0;
  for (float& value : image.data()) {
    value = std::isfinite(value) ? 1 - scale * logarithm(std::max(value, nearest) / nearest) : 0;
  }
  return image;
}

Image show_normals(Image image) {
  std::vector<float>& values = image.data();
  for (std::size_t i = 0; i < values.size(); i += 3) {
    if (values[i] == 0 && values[i + 1] == 0 && values[i + 2] == 0) continue;
    for (std::size_t c = i; c < i + 3; ++c) values[c] = 0.5f + 0.5f * values[c];
  }
  return image;
}

/// Each coordinate from 0 to 1 within the box of all that is seen.
Image show_positions(Image image) {
  std::vector<float>& values = image.data();
  auto const is_seen = [&](float const* pixel) { return pixel[0] != 0 || pixel[1] != 0 || pixel[2] != 0; };
  std::array<float, 3> low, high;
  low.fill(std::numeric_limits<float>::infinity());
  high.fill(-std::numeric_limits<float>::infinity());
  for (std::size_t i = 0; i < values.size(); i += 3) {
    for (std::size_t c = 0; c < 3 && is_seen(&values[i]); ++c) {
      low[c] = std::min(low[c], values[i + c]);
      high[c] = std::max(high[c], values[i + c]);
    }
  }
  for (std::size_t i = 0; i < values.size(); i += 3) {
    if (!is_seen(&values[i])) continue;
    for (std::size_t c = 0; c < 3; ++c) {
      values[i + c] = high[c] > low[c] ? (values[i + c] - low[c]) / (high[c] - low[c]) : 0.5f;
    }
  }
  return image;
}

/// Neighbouring numbers get hues far apart: by the golden ratio each falls into the largest gap of those before.
Image show_numbers(Film const& film, FilmPlane plane) {
  constexpr double golden_ratio = 0.6180339887498949;
  Image image(film.size());
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      double const number = film.number(plane, x, y);
      if (number == 0) continue;
      double const hue = 6 * std::fmod(number * golden_ratio, 1.0);
      double const lightness = 0.55 + 0.45 * std::fmod(number * golden_ratio * golden_ratio, 1.0);
      for (int c = 0; c < 3; ++c) {
        double const ramp = std::abs(std::fmod(hue + 6 - 2 * c, 6.0) - 3) - 1;
        image.pixel(x, y)[c] = float(lightness * (0.25 + 0.75 * std::clamp(ramp, 0.0, 1.0)));
      }
    }
  }
  return image;
}

}  // namespace

Image show_plane(Film const& film, FilmPlane plane, Transfer transfer) {
  switch (plane) {
    case FilmPlane::radiance:
    case FilmPlane::alpha:
      return values_of(film, plane);
    case FilmPlane::albedo:
      return show_colors(values_of(film, plane), transfer);
    case FilmPlane::normal:
      return show_normals(values_of(film, plane));
    case FilmPlane::depth:
      return show_depth(values_of(film, plane));
    case FilmPlane::position:
      return show_positions(values_of(film, plane));
    case FilmPlane::object:
    case FilmPlane::instance:
    case FilmPlane::material:
      return show_numbers(film, plane);
  }
  return {};
}

}  // namespace lichtraum
