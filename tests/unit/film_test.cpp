#include "lichtraum/film.hpp"

#include <algorithm>
#include <stdexcept>

#include "support/catch.hpp"
#include "support/film_of.hpp"

using namespace lichtraum;

namespace {

/// A pixel whose samples are first, first + 1, ... end - 1.
Film counting(int first, int end) {
  Film film({0, 0, 1, 1}, {FilmPlane::radiance}, first);
  while (film.samples().end < end) {
    int const sample = film.samples().end;
    if (sample > first && sample % Film::block_size == 0) film.close_block();
    film.floats(FilmPlane::radiance)[0] += float(sample);
    film.set_end(sample + 1);
  }
  return film;
}

}  // namespace

TEST_CASE("a film's value is the mean of its samples", "[unit][film]") {
  CHECK(counting(0, 1).value(FilmPlane::radiance, 0, 0) == 0);
  CHECK(counting(0, 16).value(FilmPlane::radiance, 0, 0) == 7.5f);
  CHECK(counting(0, 50).value(FilmPlane::radiance, 0, 0) == 24.5f);
  CHECK(counting(32, 64).value(FilmPlane::radiance, 0, 0) == 47.5f);
  CHECK(counting(0, 50).values(FilmPlane::radiance) == std::vector<float>{24.5f, 0, 0});
  CHECK(counting(48, 99).values(FilmPlane::radiance) == std::vector<float>{73, 0, 0});
}

TEST_CASE("films merge in order, at borders of blocks only", "[unit][film]") {
  Film film = counting(0, 16);
  film.merge(counting(16, 80));
  film.merge(counting(80, 90));
  CHECK(film.samples() == SampleRange{0, 90});
  CHECK(film.value(FilmPlane::radiance, 0, 0) == 44.5f);
  CHECK_THROWS_AS(film.merge(counting(96, 97)), std::invalid_argument);  // a gap
  CHECK_THROWS_AS(counting(0, 16).merge(counting(0, 16)), std::invalid_argument);
  Film odd = counting(0, 17);
  CHECK_THROWS_AS(odd.merge(counting(32, 33)), std::invalid_argument);
  Film other({0, 0, 1, 1}, {FilmPlane::alpha}, 16);
  Film whole = counting(0, 16);
  CHECK_THROWS_AS(whole.merge(other), std::invalid_argument);
  CHECK_THROWS_AS(whole.merge(Film({0, 0, 2, 1}, {FilmPlane::radiance}, 16)), std::invalid_argument);
  CHECK_THROWS_AS(Film({0, 0, 1, 1}, {FilmPlane::radiance}, 8), std::invalid_argument);
}

TEST_CASE("the last block can be dropped", "[unit][film]") {
  Film film = counting(0, 40);
  film.drop_last_block();
  CHECK(film.samples() == SampleRange{0, 32});
  CHECK(film.value(FilmPlane::radiance, 0, 0) == 15.5f);
  film.close_block();
  film.floats(FilmPlane::radiance)[0] += 32;
  film.set_end(33);
  CHECK(film.value(FilmPlane::radiance, 0, 0) == 16);
}

TEST_CASE("planes that are not kept are gone", "[unit][film]") {
  Film film({0, 0, 2, 2}, {FilmPlane::radiance, FilmPlane::object});
  film.set_end(1);
  film.keep({FilmPlane::object});
  CHECK(film.planes() == PlaneSet{FilmPlane::object});
  CHECK(film.values(FilmPlane::radiance).empty());
  CHECK(film.numbers(FilmPlane::object).size() == 4);
}

TEST_CASE("a plane that a film lacks has no values", "[unit][film]") {
  Film const film({0, 0, 2, 2}, {FilmPlane::radiance, FilmPlane::depth, FilmPlane::object}, 16);
  CHECK(film.value(FilmPlane::radiance, 1, 1) != 0);  // of no samples
  CHECK_THROWS_AS(film.value(FilmPlane::alpha, 0, 0), std::invalid_argument);
  CHECK_THROWS_AS(film.value(FilmPlane::depth, 0, 0), std::invalid_argument);  // only with sample 0
  CHECK_THROWS_AS(film.number(FilmPlane::object, 0, 0), std::invalid_argument);
  CHECK_THROWS_AS(Film({0, 0, -1, 2}, {FilmPlane::radiance}), std::invalid_argument);
}

TEST_CASE("planes are shown as pictures", "[unit][film]") {
  auto const shown = [](FilmPlane plane, std::vector<float> const& values) {
    std::size_t const channels = info_of(plane).channels.size();
    Film film({0, 0, int(values.size() / channels), 1}, {plane});
    std::ranges::copy(values, film.floats(plane).begin());
    film.set_end(1);
    return show_plane(film, plane).data();
  };
  auto const grey = shown(FilmPlane::depth, {2, 4, std::numeric_limits<float>::infinity()});
  CHECK((grey[0] == 1 && grey[1] == 1 && grey[2] == 1));
  CHECK((grey[3] > 0 && grey[3] < 0.2f));
  CHECK(grey[6] == 0);
  CHECK(shown(FilmPlane::normal, {0, 0, -1, 0, 0, 0}) == std::vector<float>{0.5f, 0.5f, 0, 0, 0, 0});
  CHECK(shown(FilmPlane::position, {-1, 5, 7, 3, 5, 8, 0, 0, 0}) ==
        std::vector<float>{0, 0.5f, 0, 1, 0.5f, 1, 0, 0, 0});
  CHECK(shown(FilmPlane::alpha, {0.25f}) == std::vector<float>{0.25f, 0.25f, 0.25f});
  Film film({0, 0, 3, 1}, {FilmPlane::object});
  for (std::uint32_t i = 0; i < 3; ++i) film.numbers(FilmPlane::object)[i] = i;
  auto const colors = show_plane(film, FilmPlane::object).data();
  CHECK((colors[0] == 0 && colors[1] == 0 && colors[2] == 0));
  double apart = 0;
  for (std::size_t c = 0; c < 3; ++c) apart += std::abs(double(colors[3 + c] - colors[6 + c]));
  CHECK(apart > 0.3);
}

TEST_CASE("films are put together of parts, stored and read back", "[unit][film]") {
  PlaneSet const planes{FilmPlane::radiance, FilmPlane::depth, FilmPlane::object};
  for (int const end : {1, 16, 17, 40}) {
    Film whole = Film::of_samples({10, 20, 3, 2}, planes, {0, end});
    for (Region const& region : {Region{10, 20, 2, 2}, Region{12, 20, 1, 1}, Region{12, 21, 1, 1}}) {
      Film part(region, planes);
      for (int sample = 0; sample < end; ++sample) {
        if (sample > 0 && sample % Film::block_size == 0) part.close_block();
        for (float& value : part.floats(FilmPlane::radiance)) value += float(sample);
        part.set_end(sample + 1);
      }
      for (auto& value : part.numbers(FilmPlane::object)) value = std::uint32_t(region.x + region.y);
      Film stored = Film::of_samples(region, planes, {0, end});
      auto const from = part.arrays(), to = stored.arrays();
      REQUIRE(from.size() == to.size());
      for (std::size_t i = 0; i < to.size(); ++i) {
        REQUIRE(from[i].size() == to[i].size());
        std::copy(from[i].begin(), from[i].end(), to[i].begin());
      }
      whole.place(stored);
    }
    for (int const x : {0, 1, 2}) {
      for (int const y : {0, 1}) {
        CHECK(whole.value(FilmPlane::radiance, x, y, 2) == float(end - 1) / 2);
        CHECK(whole.number(FilmPlane::object, x, y) == std::uint32_t(x < 2 ? 30 : 32 + y));
      }
    }
    CHECK_THROWS_AS(whole.place(Film::of_samples({12, 20, 2, 1}, planes, {0, end})), std::invalid_argument);
    CHECK_THROWS_AS(whole.place(Film::of_samples({10, 20, 1, 1}, planes, {0, end + 1})), std::invalid_argument);
  }
  CHECK(Film::of_samples({0, 0, 1, 1}, planes, {16, 40}).arrays().size() == 2);
}
