#include "lichtraum/denoise.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "support/catch.hpp"
#include "support/noisy_room.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

namespace {

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

/// Of one colour, without guides.
NoisyPicture plain(Resolution const& size, float value) {
  NoisyPicture picture;
  picture.size = size;
  picture.radiance.assign(3 * std::size_t(size.width) * std::size_t(size.height), value);
  return picture;
}

double gain(NoisyPicture const& picture, std::vector<float> const& truth) {
  return mean_square_error(picture.radiance, truth) / mean_square_error(filter_noise(picture), truth);
}

float largest_difference(std::vector<float> const& a, std::vector<float> const& b) {
  float largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    float const difference = std::abs(a[i] - b[i]);
    if (!(difference <= largest)) largest = difference;
  }
  return largest;
}

}  // namespace

TEST_CASE("the built-in filter takes out most of the noise", "[unit][denoise]") {
  for (int const samples : {4, 16, 64}) {
    NoisyRoom const room({320, 200}, samples);
    INFO(samples << " samples");
    CHECK(gain(room.picture, room.truth) > (samples == 64 ? 3 : 6));
  }
  NoisyRoom room({320, 200}, 16);
  room.picture.depth.clear();
  CHECK(gain(room.picture, room.truth) > 6);
  room.picture.albedo.clear();
  room.picture.normal.clear();
  CHECK(gain(room.picture, room.truth) > 1.5);  // textures and noise look alike
}

TEST_CASE("no light is lost or won", "[unit][denoise]") {
  NoisyRoom const room({320, 200}, 16);
  double before = 0, after = 0;
  auto const filtered = filter_noise(room.picture);
  for (std::size_t i = 0; i < filtered.size(); ++i) {
    before += room.picture.radiance[i];
    after += filtered[i];
  }
  CHECK(after == Approx(before).epsilon(0.01));
}

TEST_CASE("the borders of a picture are as bright as its middle", "[unit][denoise]") {
  // Black surfaces without normals: the guides cannot tell them from what lies beside the picture.
  constexpr int side = 201;
  NoisyPicture picture = plain({side, side}, 0);
  picture.albedo = picture.normal = picture.radiance;
  std::mt19937 generator(7);
  for (float& value : picture.radiance) value = 0.5f + float(generator() % 1000) / 1000;
  auto const filtered = filter_noise(picture);
  auto const mean_of = [&](int first_x, int first_y, int step_x, int step_y) {
    double sum = 0;
    for (int i = 0; i < side; ++i) {
      sum += filtered[3 * std::size_t(side * (first_y + i * step_y) + first_x + i * step_x) + 1];
    }
    return sum / side;
  };
  CHECK(mean_of(0, 0, 1, 0) == Approx(1).epsilon(0.02));
  CHECK(mean_of(0, side - 1, 1, 0) == Approx(1).epsilon(0.02));
  CHECK(mean_of(0, 0, 0, 1) == Approx(1).epsilon(0.02));
  CHECK(mean_of(side - 1, 0, 0, 1) == Approx(1).epsilon(0.02));
}

TEST_CASE("what textures do to light is kept", "[unit][denoise]") {
  // Fine stripes, paler than the guide of albedo tells apart, under light without noise.
  NoisyPicture picture = plain({64, 16}, 1);
  picture.albedo.assign(picture.radiance.size(), 0.6f);
  for (std::size_t i = 0; i < picture.radiance.size(); ++i) {
    if (i / 3 % 2 == 0) picture.albedo[i] = 0.5f;
    picture.radiance[i] = picture.albedo[i] * (i / 3 % 5 == 0 ? 1.2f : 1.0f);
  }
  auto const filtered = filter_noise(picture);
  for (std::size_t i = 3 * (64 * 8 + 20); i < 3 * (64 * 8 + 40); i += 6) {
    CHECK(filtered[i] / filtered[i + 3] == Approx(picture.albedo[i] / picture.albedo[i + 3]).epsilon(0.1));
  }
}

TEST_CASE("what has no noise stays as it is", "[unit][denoise]") {
  for (float const value : {0.0f, 1e-6f, 0.7f, 12345.0f}) {
    NoisyPicture const picture = plain({67, 41}, value);
    CHECK(largest_difference(filter_noise(picture), picture.radiance) <= 1e-6f * value);
  }
  // Edges of albedo, of normals and of depth, with another light on each side.
  NoisyPicture picture = plain({60, 40}, 1);
  picture.albedo.assign(picture.radiance.size(), 0.25f);
  picture.normal.assign(picture.radiance.size(), 0);
  picture.depth.assign(60 * 40, 3);
  for (std::size_t i = 0; i < 60 * 40; ++i) {
    std::size_t const x = i % 60, y = i / 60;
    picture.normal[3 * i + (x < 20 ? 0 : 1)] = 1;
    if (x < 20) picture.radiance[3 * i] = picture.radiance[3 * i + 1] = 0.2f;
    if (y < 20) {
      for (std::size_t c = 0; c < 3; ++c) picture.albedo[3 * i + c] = 1;
      picture.radiance[3 * i + 2] = 5;
    }
    if (x > 45) {
      picture.depth[i] = 9;
      picture.radiance[3 * i] = 2;
    }
  }
  CHECK(largest_difference(filter_noise(picture), picture.radiance) < 1e-5f);
}

TEST_CASE("values that are not finite stay where they are, as 0", "[unit][denoise]") {
  for (float const bad : {not_a_number, infinity, -infinity}) {
    NoisyRoom room({80, 50}, 16);
    auto const clean = filter_noise(room.picture);
    std::size_t const i = 3 * (25 * 80 + 8);
    for (std::size_t c = i; c < i + 3; ++c) room.picture.radiance[c] = bad;
    auto const filtered = filter_noise(room.picture);
    CHECK(std::ranges::all_of(filtered, [](float value) { return std::isfinite(value); }));
    NoisyRoom other({80, 50}, 16);
    for (std::size_t c = i; c < i + 3; ++c) other.picture.radiance[c] = 0;
    CHECK(filtered == filter_noise(other.picture));
    room.picture.albedo[i] = bad;
    room.picture.normal[i] = bad;
    room.picture.depth[i / 3] = bad;
    auto const without = filter_noise(room.picture);
    CHECK(std::ranges::all_of(without, [](float value) { return std::isfinite(value); }));
    // Far away nothing has changed.
    CHECK(std::equal(clean.end() - 30, clean.end(), without.end() - 30));
  }
}

TEST_CASE("very bright and very dark pictures are filtered alike", "[unit][denoise]") {
  NoisyRoom const room({64, 40}, 16);
  auto const filtered = filter_noise(room.picture);
  for (float const factor : {0x1p-20f, 0x1p20f}) {
    NoisyPicture scaled = room.picture;
    for (float& value : scaled.radiance) value *= factor;
    auto result = filter_noise(scaled);
    for (float& value : result) value /= factor;
    CHECK(largest_difference(result, filtered) < 1e-4f);
  }
  NoisyPicture const huge = plain({20, 20}, 1e30f);
  CHECK(std::ranges::all_of(filter_noise(huge), [](float value) { return std::isfinite(value) && value > 1e15f; }));
}

TEST_CASE("pictures may be as narrow as a pixel", "[unit][denoise]") {
  for (Resolution const size : {Resolution{1, 1}, {1, 50}, {50, 1}, {2, 3}, {15, 2}, {16, 2}, {17, 2}}) {
    INFO(size.width << "x" << size.height);
    NoisyPicture const picture = plain(size, 0.5f);
    CHECK(largest_difference(filter_noise(picture), picture.radiance) < 1e-6f);
    NoisyRoom const room(size, 4);
    auto const filtered = filter_noise(room.picture);
    CHECK(filtered.size() == room.truth.size());
    CHECK(std::ranges::all_of(filtered, [](float value) { return value > 0 && value < 10; }));
  }
}

TEST_CASE("a pixel depends on what is near it only", "[unit][denoise]") {
  // So the work of one thread cannot be seen in another's: a part gives the bytes of the whole.
  NoisyRoom const room({200, 150}, 16);
  NoisyPicture part;
  part.size = {200, 100};
  auto const first = [](std::vector<float> const& plane, std::size_t channels) {
    return std::vector<float>(plane.begin(), plane.begin() + std::ptrdiff_t(channels * 200 * 100));
  };
  part.radiance = first(room.picture.radiance, 3);
  part.albedo = first(room.picture.albedo, 3);
  part.normal = first(room.picture.normal, 3);
  part.depth = first(room.picture.depth, 1);
  auto const whole = filter_noise(room.picture), of_part = filter_noise(part);
  CHECK(std::equal(of_part.begin(), of_part.begin() + 3 * 200 * 40, whole.begin()));
}

TEST_CASE("planes of other sizes are refused", "[unit][denoise]") {
  NoisyPicture picture = plain({8, 8}, 1);
  picture.albedo.assign(3 * 8 * 7, 1);
  CHECK_THROWS_AS(filter_noise(picture), std::invalid_argument);
  picture.albedo.clear();
  picture.depth.assign(3 * 8 * 8, 1);
  CHECK_THROWS_AS(filter_noise(picture), std::invalid_argument);
  CHECK_THROWS_AS(noisy_picture(Film({0, 0, 4, 4}, {FilmPlane::albedo})), std::invalid_argument);
}
