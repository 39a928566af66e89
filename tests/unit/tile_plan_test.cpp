#include "render/tile_plan.hpp"

#include <random>
#include <tuple>
#include <utility>
#include <vector>

#include "support/catch.hpp"

using namespace lichtraum;

TEST_CASE("a plan covers each pixel's samples once and in order, whatever the budgets", "[unit][tile]") {
  std::mt19937 random(1);
  using Size = std::tuple<int, int, int>;
  for (auto const& [width, height, samples] : {Size(1, 1, 1), Size(7, 9, 1), Size(64, 33, 5), Size(100, 50, 64)}) {
    for (auto const& [largest, launch_pixels] :
         {std::pair(1.0, 0.0), {100, 0}, {5000, 0}, {1e9, 0}, {5000, 300}, {1e9, 300}, {1e9, 1e6}}) {
      std::uniform_real_distribution<double> budget(0.1, largest);
      std::vector<int> done(std::size_t(width * height), 0);
      TilePlan plan({3, 5, width, height}, samples, 0, launch_pixels);
      while (!plan.is_done()) {
        device::Tile const tile = plan.next(budget(random));
        REQUIRE(tile.width * tile.height * tile.sample_count > 0);
        for (device::uint y = tile.y; y < tile.y + tile.height; ++y) {
          for (device::uint x = tile.x; x < tile.x + tile.width; ++x) {
            int& count = done.at((y - 5) * device::uint(width) + (x - 3));
            if (count != int(tile.first_sample)) FAIL("samples of a pixel are out of order");
            count += int(tile.sample_count);
          }
        }
        if (!plan.is_between_pixels()) {
          Region const pixels = plan.current_pixels();
          CHECK(pixels.x == int(tile.x));
          CHECK(pixels.width == int(tile.width));
          CHECK(pixels.y == int(tile.y));
          CHECK(pixels.height == int(tile.height));
        }
      }
      for (int const count : done) {
        if (count != samples) FAIL("a pixel has " << count << " samples");
      }
    }
  }
}

TEST_CASE("a plan's tiles keep to the budget where 8 x 8 pixels and one sample allow", "[unit][tile]") {
  TilePlan plan({0, 0, 640, 480}, 16);
  while (!plan.is_done()) {
    device::Tile const tile = plan.next(20'000);
    CHECK(double(tile.width) * tile.height * tile.sample_count <= 20'000);
  }
}

TEST_CASE("a plan with a number of pixels takes more samples of them only when it has as many", "[unit][tile]") {
  double const launch_pixels = 64 * 640;
  TilePlan plan({0, 0, 640, 480}, 16, 0, launch_pixels);
  device::Tile const small = plan.next(8 * 640);
  CHECK(small.width * small.height == 8 * 640);
  CHECK(small.sample_count == 1);
  while (!plan.is_between_pixels()) plan.next(1e9);
  device::Tile const large = plan.next(4 * launch_pixels);
  CHECK(double(large.width) * large.height == launch_pixels);
  CHECK(large.sample_count == 4);
}

TEST_CASE("a large budget takes the whole picture at once", "[unit][tile]") {
  TilePlan plan({0, 0, 640, 480}, 4);
  device::Tile const tile = plan.next(1e9);
  CHECK(plan.is_done());
  CHECK(tile.width == 640);
  CHECK(tile.height == 480);
  CHECK(tile.sample_count == 4);
}

TEST_CASE("a plan may go on with later samples", "[unit][tile]") {
  TilePlan plan({0, 0, 8, 8}, 4, 3);
  device::uint next = 3;
  while (!plan.is_done()) {
    device::Tile const tile = plan.next(100);
    CHECK(tile.first_sample == next);
    next += tile.sample_count;
  }
  CHECK(next == 7);
}
