/// The path integrator of the kernels, and the reference tracer's: two estimators of one integral (docs/RAYTRACING.md,
/// section 19). Whatever they disagree about, one of them does wrong.

#include <array>
#include <map>

#include "support/catch.hpp"
#include "support/path_scenes.hpp"
#include "support/picture_check.hpp"
#include "support/skip.hpp"
#include "support/welch.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

namespace {

constexpr Resolution size{32, 24};
constexpr int block_size = 8;
constexpr int columns = size.width / block_size;
constexpr int block_count = columns * (size.height / block_size);

/// A picture is drawn several times, each time by other random numbers. So its measurements are independent, whatever
/// the points within one drawing have to do with each other.
constexpr int repetitions = 16;

RenderRequest request_for(PathScene const& drawn, int samples, int seed) {
  RenderRequest request = whole_picture(drawn.scene.cameras.front(), size);
  request.integrator = Integrator::path;
  request.sampling = {Sampling::Pattern::seeded, samples};
  request.max_depth = drawn.max_depth;
  request.ground = drawn.ground;
  request.seed = std::uint64_t(seed);
  request.planes = {FilmPlane::radiance, FilmPlane::albedo, FilmPlane::normal};
  if (drawn.has_alpha_plane) request.planes.add(FilmPlane::alpha);
  if (drawn.sees_environment) request.background = Background::environment();
  return request;
}

/// What is measured of a picture: the mean of a channel of a plane, of a block of pixels or of all of them.
struct Quantity {
  FilmPlane plane;
  std::size_t channel;
  int block;  // block_count: all
  auto operator<=>(Quantity const&) const = default;
};
using Measurements = std::map<Quantity, std::vector<double>>;

void measure(Film const& film, Measurements& measurements) {
  for (FilmPlane const plane : {FilmPlane::radiance, FilmPlane::alpha, FilmPlane::albedo, FilmPlane::normal}) {
    if (!film.planes().has(plane)) continue;
    auto const values = film.values(plane);
    std::size_t const channels = info_of(plane).channels.size();
    for (std::size_t channel = 0; channel < channels; ++channel) {
      std::array<double, block_count + 1> sums{};
      for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
          double const value = values[channels * std::size_t(y * size.width + x) + channel];
          sums[std::size_t(y / block_size * columns + x / block_size)] += value / (block_size * block_size);
          sums[block_count] += value / (size.width * size.height);
        }
      }
      for (int block = 0; block <= block_count; ++block) {
        measurements[{plane, channel, block}].push_back(sums[std::size_t(block)]);
      }
    }
  }
}

Measurements measure(DeviceInfo const& device, PathScene const& drawn, int samples) {
  auto const renderer = make_renderer(device);
  renderer->set_scene(drawn.scene);
  Measurements measurements;
  for (int seed = 1; seed <= repetitions; ++seed) {
    Film film;
    auto const result = renderer->render(request_for(drawn, samples, seed), film);
    CHECK(result.statistics.rays.not_finite == 0);
    measure(film, measurements);
  }
  return measurements;
}

double mean(std::vector<double> const& values) {
  double sum = 0;
  for (double const value : values) sum += value / double(values.size());
  return sum;
}

/// Welch's t-test for each block of 8 x 8 pixels and for the whole picture, in each channel of the radiance and of what
/// is known of first surfaces: 13 x 9 comparisons a scene, 13 more with alpha. All of a scene together fail with
/// probability 0.1 % where nothing is wrong; the seeds being fixed, a test that passes does so always.
constexpr double level = 0.001;
/// By which the means may differ: floats know no better where a surface fills a pixel.
constexpr double tolerance = 1e-4;

/// `samples`: per pixel and drawing.
void check_against_oracle(int kernel_samples, int oracle_samples) {
  for (PathScene const& drawn : path_scenes()) {
    auto const kernel = measure(opencl_devices().front(), drawn, kernel_samples);
    auto const oracle = measure(reference_device(), drawn, oracle_samples / drawn.cost);
    double const single_level = sidak_level(level, kernel.size());
    for (auto const& [quantity, values] : kernel) {
      auto const& expected = oracle.at(quantity);
      INFO(drawn.name << ": " << info_of(quantity.plane).name << ", channel " << quantity.channel << " of block "
                      << quantity.block << " is " << mean(values) << ", expected " << mean(expected));
      CHECK(welch_probability(values, expected, tolerance) >= single_level);
    }
  }
}

}  // namespace

TEST_CASE("paths: the reference tracer agrees, by another estimator", "[image][path][oracle][statistics]") {
  REQUIRE_OPENCL_DEVICE();
  check_against_oracle(32, 48);
}

TEST_CASE("paths: the reference tracer agrees in many samples", "[image][path][oracle][statistics][long][.]") {
  REQUIRE_OPENCL_DEVICE();
  check_against_oracle(128, 320);
}
