#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <optional>

#include "lichtraum/denoise.hpp"
#include "lichtraum/error.hpp"
#include "support/catch.hpp"
#include "support/noisy_room.hpp"
#include "support/skip.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

namespace {

/// As long as it lives, an environment variable has another value, or none.
class Variable {
 public:
  Variable(char const* name, std::optional<std::string> const& value) : name_(name) {
    if (char const* const old = std::getenv(name)) old_ = old;
    set(value);
  }
  ~Variable() { set(old_); }
  Variable(Variable const&) = delete;
  Variable& operator=(Variable const&) = delete;

 private:
  void set(std::optional<std::string> const& value) { value ? ::setenv(name_, value->c_str(), 1) : ::unsetenv(name_); }
  char const* name_;
  std::optional<std::string> old_;
};

std::string why_unavailable() {
  try {
    OpenImageDenoise const library;
    return library.name();
  } catch (Error const& error) {
    CHECK(error.kind() == ErrorKind::unavailable);
    return error.what();
  }
}

}  // namespace

TEST_CASE("Open Image Denoise is looked for where the environment says", "[unit][denoise]") {
  Variable const chosen("LICHTRAUM_OIDN", LICHTRAUM_FAKE_OIDN);
  CHECK(OpenImageDenoise().name() == "Open Image Denoise 2.7.9");
  NoisyRoom const room({16, 16}, 4);
  auto const filtered = OpenImageDenoise().filter_noise(room.picture);
  auto expected = room.picture.radiance;
  for (float& value : expected) value *= 0.5f;
  CHECK(filtered == expected);

  Variable const missing("LICHTRAUM_OIDN", "/nowhere/liboidn.so");
  CHECK_THAT(why_unavailable(), contains_text("/nowhere/liboidn.so: cannot open"));
  Variable const folder("LICHTRAUM_OIDN", "/usr");
  CHECK_THAT(why_unavailable(), contains_text("/usr/libOpenImageDenoise.so.2: cannot open"));
  Variable const text("LICHTRAUM_OIDN", "/etc/passwd");
  CHECK_THAT(why_unavailable(), contains_text("/etc/passwd: "));
}

TEST_CASE("another version, or a faulty one, is not used", "[unit][denoise]") {
  {
    Variable const lacking("LICHTRAUM_OIDN", LICHTRAUM_LACKING_OIDN);
    CHECK(why_unavailable() == "it lacks the function oidnExecuteFilter, so it is not version 2");
  }
  Variable const chosen("LICHTRAUM_OIDN", LICHTRAUM_FAKE_OIDN);
  {
    Variable const version("FAKE_OIDN", "version");
    CHECK(why_unavailable() == "it is Open Image Denoise 3.7.9, and version 2 is needed");
  }
  {
    Variable const device("FAKE_OIDN", "device");
    CHECK(why_unavailable() == "unsupported hardware (its error 5)");
  }
  Variable const memory("FAKE_OIDN", "memory");
  OpenImageDenoise const library;
  NoisyRoom const room({16, 16}, 4);
  CHECK_THROWS_WITH(library.filter_noise(room.picture), "out of memory (its error 4)");
}

TEST_CASE("the built-in filter serves where Open Image Denoise fails, and that is told once", "[unit][denoise]") {
  NoisyRoom const room({32, 32}, 4);
  auto const expected = filter_noise(room.picture);
  Variable const chosen("LICHTRAUM_OIDN", LICHTRAUM_FAKE_OIDN);
  {
    Variable const memory("FAKE_OIDN", "memory");
    Denoiser denoiser(filter_noise);
    CHECK(denoiser.name(Denoising::on) == "Open Image Denoise 2.7.9");
    CHECK(denoiser.take_note().empty());
    CHECK(denoiser.denoised(room.picture, Denoising::on) == expected);
    CHECK(denoiser.denoised(room.picture, Denoising::on) == expected);
    CHECK(denoiser.take_note() ==
          "noise is filtered by lichtraum's own filter, as Open Image Denoise cannot be used: out of memory (its error "
          "4)");
    CHECK(denoiser.take_note().empty());
    CHECK(denoiser.name(Denoising::on) == "the built-in filter");
  }
  {
    Variable const missing("LICHTRAUM_OIDN", "/nowhere");
    Denoiser denoiser(filter_noise);
    CHECK(denoiser.name(Denoising::on) == "the built-in filter");
    CHECK(denoiser.denoised(room.picture, Denoising::on) == expected);
    CHECK_THAT(denoiser.take_note(), contains_text("/nowhere: cannot open"));
    CHECK(denoiser.take_note().empty());
  }
  Denoiser denoiser(filter_noise);
  CHECK(denoiser.denoised(room.picture, Denoising::builtin) == expected);
  CHECK(denoiser.denoised(room.picture, Denoising::on) != expected);
  CHECK(denoiser.take_note().empty());
}

TEST_CASE("a film's radiance is denoised, its alpha is not", "[unit][denoise]") {
  Film film({3, 4, 2, 1}, {FilmPlane::radiance, FilmPlane::alpha, FilmPlane::albedo});
  for (int i = 0; i < 6; ++i) film.floats(FilmPlane::radiance)[std::size_t(i)] = 8.0f * float(i);
  film.floats(FilmPlane::alpha)[0] = 2;
  film.set_end(4);
  Denoiser denoiser([](NoisyPicture const& picture) {
    CHECK(picture.size == Resolution{2, 1});
    CHECK(picture.albedo.size() == 6);
    CHECK(picture.normal.empty());
    auto radiance = picture.radiance;
    for (float& value : radiance) value += 1;
    return radiance;
  });
  Film const denoised = denoiser.denoised(film, Denoising::builtin);
  CHECK(denoised.region() == film.region());
  CHECK(denoised.planes() == PlaneSet{FilmPlane::radiance, FilmPlane::alpha});
  CHECK(denoised.values(FilmPlane::radiance) == std::vector<float>{1, 3, 5, 7, 9, 11});
  CHECK(denoised.values(FilmPlane::alpha) == std::vector<float>{0.5f, 0});
}

TEST_CASE("alpha with noise is denoised where not all samples have hit something", "[unit][denoise]") {
  Film film({0, 0, 4, 1}, {FilmPlane::radiance, FilmPlane::alpha});
  float const sums[] = {4, 2, -0.5f, 3.9f};
  std::ranges::copy(sums, film.floats(FilmPlane::alpha).begin());
  film.set_end(4);
  Denoiser denoiser([](NoisyPicture const& picture) {
    auto smooth = picture.radiance;
    for (float& value : smooth) value += 0.125f;
    return smooth;
  });
  Film const denoised = denoiser.denoised(film, Denoising::builtin, {.in_alpha = true});
  CHECK(denoised.values(FilmPlane::radiance) == std::vector<float>(12, 0.125f));
  CHECK(denoised.values(FilmPlane::alpha) == std::vector<float>{1, 0.625f, 0.125f, 1});
}

TEST_CASE("an even picture stays even, in its corners as well", "[unit][denoise]") {
  Variable const anywhere("LICHTRAUM_OIDN", std::nullopt);
  std::optional<OpenImageDenoise> library;
  try {
    library.emplace();
  } catch (Error const& error) {
    SKIP_TEST(error.what());
  }
  for (Resolution const size : {Resolution{128, 72}, {320, 180}, {5, 3}}) {
    INFO(size.width);
    std::size_t const pixels = std::size_t(size.width) * std::size_t(size.height);
    NoisyPicture picture;
    picture.size = size;
    picture.radiance.assign(3 * pixels, 0.5f);
    picture.albedo.assign(3 * pixels, 0);
    picture.normal.assign(3 * pixels, 0);
    auto const filtered = library->filter_noise(picture);
    auto const [least, most] = std::ranges::minmax(filtered);
    CHECK(least > 0.49f);
    CHECK(most < 0.51f);
  }
}

TEST_CASE("Open Image Denoise takes out the noise", "[unit][denoise]") {
  Variable const anywhere("LICHTRAUM_OIDN", std::nullopt);
  std::optional<OpenImageDenoise> library;
  try {
    library.emplace();
  } catch (Error const& error) {
    SKIP_TEST(error.what());
  }
  CHECK(library->name().substr(0, 20) == "Open Image Denoise 2");
  NoisyRoom room({320, 200}, 16);
  room.picture.radiance[3 * 1000] = std::numeric_limits<float>::quiet_NaN();
  auto const filtered = library->filter_noise(room.picture);
  room.picture.radiance[3 * 1000] = 0;
  CHECK(mean_square_error(room.picture.radiance, room.truth) / mean_square_error(filtered, room.truth) > 3);
  room.picture.has_noisy_guides = true;
  CHECK(mean_square_error(library->filter_noise(room.picture), room.truth) <
        mean_square_error(room.picture.radiance, room.truth) / 3);
  room.picture.albedo.clear();
  CHECK(library->filter_noise(room.picture).size() == filtered.size());

  std::vector<std::vector<float>> results;
  for (char const* const threads : {"1", "2"}) {
    Variable const count("OIDN_NUM_THREADS", threads);
    results.push_back(OpenImageDenoise().filter_noise(NoisyRoom({160, 100}, 16).picture));
  }
  CHECK(results[0] == results[1]);
}
