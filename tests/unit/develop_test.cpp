#include <cmath>
#include <limits>
#include <stdexcept>

#include "support/catch.hpp"
#include "support/film_of.hpp"

using namespace lichtraum;

namespace {

Rgb developed(Rgb const& radiance, Development const& development) {
  Image image(Resolution{1, 1});
  for (int c = 0; c < 3; ++c) image.data()[std::size_t(c)] = float(radiance[c]);
  Image const result = develop(test::film_of(image), development);
  return {double(result.data()[0]), double(result.data()[1]), double(result.data()[2])};
}

}  // namespace

TEST_CASE("without tone map and transfer function a pixel stays as computed", "[unit][develop]") {
  CHECK(developed({-1, 0.5, 7}, {}) == Rgb(-1, 0.5, 7));
}

TEST_CASE("exposure comes first, in stops", "[unit][develop]") {
  CHECK(developed({1, 0.5, 3}, {2, ToneMap::none, Transfer::linear}) == Rgb(4, 2, 12));
  CHECK(developed({2, 6, 0}, {-1, ToneMap::reinhard, Transfer::linear}) == Rgb(0.5, 0.75, 0));
}

TEST_CASE("Reinhard's map is c / (c + 1)", "[unit][develop]") {
  Development const reinhard{0, ToneMap::reinhard, Transfer::linear};
  CHECK(developed({0, 1, 3}, reinhard) == Rgb(0, 0.5, 0.75));
  double const infinity = std::numeric_limits<double>::infinity();
  CHECK(developed({infinity, 3e38, 0}, reinhard) == Rgb(1, 1, 0));
}

TEST_CASE("sRGB encodes as IEC 61966-2-1 says", "[unit][develop]") {
  Development const srgb{0, ToneMap::none, Transfer::srgb};
  Rgb const encoded = developed({0.002, 0.5, 1}, srgb);
  CHECK(encoded.r == Approx(0.02584));
  CHECK(encoded.g == Approx(0.735356983));
  CHECK(encoded.b == Approx(1));
  // Both pieces meet.
  Rgb const joint = developed({0.0031308, 0.0031309, 0}, srgb);
  CHECK(joint.r == Approx(0.04045).epsilon(1e-4));
  CHECK(joint.g == Approx(joint.r).epsilon(1e-4));
  CHECK(developed({1, 1, 1}, {0, ToneMap::reinhard, Transfer::srgb}).r == Approx(0.735356983));
  for (double c = 0.004; c < 50; c *= 1.1) {
    CHECK(developed(Rgb(c), srgb).g == Approx(1.055 * std::pow(c, 1 / 2.4) - 0.055).epsilon(1e-6));
  }
}

TEST_CASE("with alpha a picture has straight colours", "[unit][develop]") {
  Film film({0, 0, 2, 1}, {FilmPlane::radiance, FilmPlane::alpha});
  // Of four samples three hit something of radiance 0.5, in the first pixel.
  film.floats(FilmPlane::radiance)[0] = 1.5f;
  film.floats(FilmPlane::alpha)[0] = 3;
  film.set_end(4);
  Image const image = develop(film, {});
  CHECK(image.alpha() == std::vector<float>{0.75f, 0});
  CHECK(image.data() == std::vector<float>{0.5f, 0, 0, 0, 0, 0});
}

TEST_CASE("what cannot be developed is refused", "[unit][develop]") {
  CHECK_THROWS_AS(developed(Rgb(1), {0, ToneMap::automatic, Transfer::linear}), std::invalid_argument);
  CHECK_THROWS_AS(develop(Film({0, 0, 1, 1}, {FilmPlane::depth}), {}), std::invalid_argument);
  CHECK_THROWS_AS(develop(Film({0, 0, 1, 1}, {FilmPlane::radiance}), {}), std::invalid_argument);
}
