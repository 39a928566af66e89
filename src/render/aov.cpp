#include "lichtraum/aov.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/elementary.hpp"

namespace lichtraum {
namespace {

float logarithm(float x) { return float(log_of(double(x))); }

void show_depth(std::vector<float>& values) {
  float nearest = std::numeric_limits<float>::infinity(), farthest = 0;
  for (float const value : values) {
    if (!std::isfinite(value)) continue;
    nearest = std::min(nearest, value);
    farthest = std::max(farthest, value);
  }
  // Equal ratios look equally far apart: a floor that reaches to the horizon leaves the things on it their contrast.
  constexpr float darkest = 0.1f;
  nearest = std::max(nearest, 1e-6f * farthest);
  float const scale = farthest > nearest ? (1 - darkest) / logarithm(farthest / nearest) : 0;
  for (float& value : values) {
    value = std::isfinite(value) ? 1 - scale * logarithm(std::max(value, nearest) / nearest) : 0;
  }
}

void show_normals(std::vector<float>& values) {
  for (std::size_t i = 0; i < values.size(); i += 3) {
    if (values[i] == 0 && values[i + 1] == 0 && values[i + 2] == 0) continue;
    for (std::size_t c = i; c < i + 3; ++c) values[c] = 0.5f + 0.5f * values[c];
  }
}

/// Neighbouring numbers get hues far apart: by the golden ratio each falls into the largest gap of those before.
void show_objects(std::vector<float>& values) {
  constexpr double golden_ratio = 0.6180339887498949;
  for (std::size_t i = 0; i < values.size(); i += 3) {
    double const number = double(values[i]);
    if (number == 0) continue;
    double const hue = 6 * std::fmod(number * golden_ratio, 1.0);
    double const lightness = 0.55 + 0.45 * std::fmod(number * golden_ratio * golden_ratio, 1.0);
    for (std::size_t c = 0; c < 3; ++c) {
      double const ramp = std::abs(std::fmod(hue + 6 - 2 * double(c), 6.0) - 3) - 1;
      values[i + c] = float(lightness * (0.25 + 0.75 * std::clamp(ramp, 0.0, 1.0)));
    }
  }
}

}  // namespace

Image aov_as_picture(Image image, Aov aov) {
  switch (aov) {
    case Aov::picture:
      break;
    case Aov::depth:
      show_depth(image.data());
      break;
    case Aov::normal:
      show_normals(image.data());
      break;
    case Aov::object_id:
      show_objects(image.data());
      break;
  }
  return image;
}

std::optional<SeenPoint> look_at_pixel(Renderer& renderer, RenderRequest view, int x, int y) {
  // A picture of that pixel alone: the same ray, from the middle of what is looked at.
  view.region = {x, y, 1, 1};
  Image image;
  auto const value = [&](Aov aov) {
    view.aov = aov;
    renderer.render(view, image);
    float const* const pixel = image.pixel(x, y);
    return Vec3(double(pixel[0]), double(pixel[1]), double(pixel[2]));
  };
  SeenPoint seen;
  seen.object = std::uint64_t(value(Aov::object_id).x);
  if (seen.object == 0) return std::nullopt;
  seen.distance = value(Aov::depth).x;
  seen.normal = value(Aov::normal);
  seen.position = view.camera.generate_ray(x + 0.5, y + 0.5, view.resolution).at(seen.distance);
  return seen;
}

}  // namespace lichtraum
