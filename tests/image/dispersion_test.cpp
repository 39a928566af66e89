/// KHR_materials_dispersion: glass whose index of refraction differs between the channels.

#include <algorithm>
#include <array>
#include <memory>

#include "support/catch.hpp"
#include "support/esdf.hpp"
#include "support/pbr.hpp"
#include "support/picture_check.hpp"
#include "support/skip.hpp"
#include "support/welch.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

namespace {

constexpr Resolution size{32, 24};
constexpr int block_size = 8;
constexpr int columns = size.width / block_size;
constexpr std::size_t block_count = std::size_t(columns) * (size.height / block_size) + 1;  // the last one is all
constexpr int repetitions = 10;

constexpr double ior = 1.6;
constexpr double dispersion = 20;  // more than any glass has
/// Half the spread of indices, as the extension has it.
constexpr double spread = (ior - 1) * 0.025 * dispersion;

/// A smooth ball, a rough one, one within a coat, and a prism, before a floor and a sky of two colours.
Scene glass_scene(double index, double spreading) {
  Scene scene = scene_of(R"(
define material clear 0 0 0  1 1 1  0 0 0 1
define material rough 0 0 0  1 1 1  0 0 0 1
define material coated 0 0 0  1 1 1  0 0 0 1
define material floor 0 0 0  0.6 0.5 0.4  0 0 0 1
define camera eye 45
transform eye rotate -10 1 0 0
transform eye translate 0 1 5
define shape sphere clear_ball -1.1 0.7 0 0.75 clear
define shape sphere rough_ball 1.1 0.7 0 0.75 rough
define shape sphere coated_ball -1.1 -0.8 0.4 0.75 coated
define shape box prism 0.3 -1.4 -0.4  1.8 -0.2 0.6 clear
define shape box floor -3 -1.7 -4  3 -1.5 3 floor
define light diffuse key -4 5 5  0.5 0.5 0.5
)");
  PbrModel glass = pbr({0.9, 0.95, 1}, 0, 0);
  glass.transmission = 1;
  glass.thickness = 1;
  glass.ior = index;
  glass.dispersion = spreading;
  auto const set = [&](char const* name) { *(*scene.materials.find(name)) = Material(name, glass); };
  set("clear");
  glass.roughness = 0.5;
  glass.attenuation_color = {0.5, 0.7, 0.9};
  glass.attenuation_distance = 1;
  set("rough");
  glass.clearcoat = 0.8;
  glass.transmission = 0.7;
  set("coated");
  EnvironmentMap map{16, 8, {}};
  for (int row = 0; row < map.height; ++row) {
    for (int column = 0; column < map.width; ++column) {
      for (float const value : {row < 4 ? 1.2f : 0.2f, column % 4 < 2 ? 1.f : 0.1f, row < 4 ? 0.3f : 0.8f}) {
        map.radiance.push_back(value);
      }
    }
  }
  scene.environment = EnvironmentLight{"made here", std::make_shared<EnvironmentMap const>(std::move(map)), 0, 1};
  return scene;
}

/// The means of a channel in the blocks of a picture, each time by other random numbers.
using Measurements = std::array<std::array<std::vector<double>, block_count>, 3>;

Measurements measure(Scene const& scene, int first_seed) {
  RenderRequest request = whole_picture(scene.cameras.front(), size);
  request.integrator = Integrator::path;
  request.sampling = {Sampling::Pattern::seeded, 48};
  request.max_depth = 5;
  request.background = Background::environment();
  auto const renderer = make_renderer(opencl_devices().front());
  renderer->set_scene(scene);
  Measurements channels;
  for (int i = 0; i < repetitions; ++i) {
    request.seed = std::uint64_t(first_seed + i);
    Film film;
    renderer->render(request, film);
    auto const values = film.values(FilmPlane::radiance);
    for (auto& blocks : channels) std::ranges::for_each(blocks, [](auto& block) { block.push_back(0); });
    for (std::size_t i_value = 0; i_value < values.size(); ++i_value) {
      std::size_t const pixel = i_value / 3, row = pixel / size.width, column = pixel % size.width;
      auto& blocks = channels[i_value % 3];
      blocks[row / block_size * columns + column / block_size].back() += values[i_value];
      blocks.back().back() += values[i_value];
    }
  }
  return channels;
}

/// The least probability that a block is the same in both.
double least_probability(Measurements const& a, Measurements const& b, std::size_t channel) {
  double least = 1;
  for (std::size_t block = 0; block < block_count; ++block) {
    least = std::min(least, welch_probability(a[channel][block], b[channel][block]));
  }
  return least;
}

}  // namespace

TEST_CASE("each channel of dispersive glass is that of glass with the channel's index", "[image][path][statistics]") {
  REQUIRE_OPENCL_DEVICE();
  Measurements const found = measure(glass_scene(ior, dispersion), 1);
  Measurements const of_index[] = {measure(glass_scene(ior - spread, 0), 101), measure(glass_scene(ior, 0), 201),
                                   measure(glass_scene(ior + spread, 0), 301)};
  for (std::size_t channel = 0; channel < 3; ++channel) {
    INFO("channel " << channel);
    CHECK(least_probability(found, of_index[channel], channel) >= sidak_level(0.001, 3 * block_count));
    CHECK(least_probability(found, of_index[(channel + 1) % 3], channel) < 1e-6);
  }
}
