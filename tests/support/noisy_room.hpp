#pragma once

#include <cmath>
#include <random>

#include "lichtraum/denoise.hpp"

namespace lichtraum::test {

/// A picture as a path tracer of few samples would draw it, and what it would be with endless ones: a checkered floor
/// and a textured wall in a light that falls off, and a ball with a shadow on the floor.
struct NoisyRoom {
  NoisyPicture picture;
  std::vector<float> truth;  // its radiance

  NoisyRoom(Resolution const& size, int samples, unsigned seed = 1) {
    picture.size = size;
    std::mt19937 generator(seed);
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) add(float(x) / float(size.width), float(y) / float(size.height));
    }
    for (std::size_t i = 0; i < truth.size(); i += 3) {
      // Most samples find little light, a few find the lamp.
      double sum = 0;
      for (int s = 0; s < samples; ++s) sum += generator() % 8 == 0 ? 4.5 : 0.5;
      for (std::size_t c = i; c < i + 3; ++c) picture.radiance.push_back(truth[c] * float(sum / samples));
    }
  }

 private:
  void add(float x, float y) {
    float const across = (x - 0.5f) / 0.2f, down = (y - 0.55f) / 0.3f;
    float const from_center = across * across + down * down;
    bool const is_ball = from_center<1, is_floor = y> 0.6f;
    float const shadow = std::abs(x - 0.75f) + std::abs(y - 0.85f) < 0.12f ? 0.3f : 1.0f;
    float const light = (0.4f + x * (1.2f - y)) * (is_floor && !is_ball ? shadow : 1.0f);
    bool const is_dark = (int(std::floor(12 * x)) + int(std::floor(12 * y))) % 2 == 0;
    float const stripe = 0.5f + 0.3f * std::sin(60 * x);
    std::array<float, 3> albedo{0.7f, stripe, 0.3f};
    if (is_floor) albedo = is_dark ? std::array{0.15f, 0.2f, 0.15f} : std::array{0.8f, 0.8f, 0.7f};
    if (is_ball) albedo = {0.8f, 0.3f, 0.2f};
    std::array<float, 3> normal{0, 0, 1};
    if (is_floor) normal = {0, 1, 0};
    if (is_ball) normal = {across, -down, std::sqrt(1 - from_center)};
    for (std::size_t c = 0; c < 3; ++c) {
      picture.albedo.push_back(albedo[c]);
      picture.normal.push_back(normal[c]);
      truth.push_back(albedo[c] * light);
    }
    picture.depth.push_back(is_ball ? 4 : is_floor ? 10 - 6 * y : 6.4f);
  }
};

inline double mean_square_error(std::vector<float> const& a, std::vector<float> const& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (double(a[i]) - b[i]) * (double(a[i]) - b[i]);
  return sum / double(a.size());
}

}  // namespace lichtraum::test
