#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "lichtraum/error.hpp"
#include "lichtraum/image_io.hpp"
#include "support/catch.hpp"
#include "support/decode.hpp"
#include "support/film_of.hpp"

using namespace lichtraum;
using test::film_of;

namespace {

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

/// Not square, not a multiple of anything, no row or column like another.
Image sample_image(Resolution const& size = {37, 23}) {
  Image image(size);
  std::mt19937 random(1);
  std::uniform_real_distribution<float> value(0, 1);
  for (float& v : image.data()) v = value(random);
  return image;
}

Image one_pixel(float r, float g, float b) {
  Image image(Resolution{1, 1});
  image.data() = {r, g, b};
  return image;
}

ImageEncoding with_bits(int bits) {
  ImageEncoding encoding;
  encoding.bits = bits;
  return encoding;
}

std::string encode(Image const& image, std::string_view format, ImageEncoding const& encoding = {}) {
  ImageFormat const& known = image_format_named(format);
  return known.encode ? known.encode(image, encoding) : known.encode_film(film_of(image), encoding);
}

/// Every value is the nearest of 0..max.
void require_nearest(DecodedImage const& decoded, Image const& image, int max) {
  REQUIRE(decoded.width == image.width());
  REQUIRE(decoded.height == image.height());
  REQUIRE(decoded.max == max);
  for (std::size_t i = 0; i < image.data().size(); ++i) {
    double const exact = double(image.data()[i]) * max;
    if (std::abs(double(decoded.values[i]) - exact) > 0.5)
      FAIL("value " << i << ": " << decoded.values[i] << " for " << exact);
  }
}

}  // namespace

TEST_CASE("lossless integer formats store the nearest value", "[unit][image]") {
  Resolution const size = GENERATE(Resolution{37, 23}, Resolution{211, 97});  // the second is written in parts
  Image const image = sample_image(size);
  for (int const bits : {8, 16}) {
    int const max = bits == 8 ? 255 : 65535;
    ImageEncoding encoding = with_bits(bits);
    require_nearest(decode(encode(image, "png", encoding)), image, max);
    require_nearest(decode(encode(image, "ppm", encoding)), image, max);
    encoding.ppm_ascii = true;
    std::string const text = encode(image, "ppm", encoding);
    CHECK(text.substr(0, 3) == "P3\n");
    require_nearest(decode(text), image, max);
  }
}

TEST_CASE("values outside [0, 1], NaN and infinity are clamped", "[unit][image]") {
  for (char const* const format : {"png", "ppm"}) {
    for (int const bits : {8, 16}) {
      float const max = bits == 8 ? 255.0f : 65535.0f;
      auto const stored = [&](float r, float g, float b) {
        return decode(encode(one_pixel(r, g, b), format, with_bits(bits))).values;
      };
      CHECK(stored(-0.5f, 1.5f, not_a_number) == std::vector<float>{0, max, 0});
      CHECK(stored(infinity, -infinity, 1) == std::vector<float>{max, 0, max});
      CHECK(stored(1e-30f, -0.0f, std::nextafter(1.0f, 0.0f)) == std::vector<float>{0, 0, max});
    }
  }
}

TEST_CASE("rounding is to the nearest, also right beside the middle", "[unit][image]") {
  for (int k = 0; k < 255; ++k) {
    float const middle = static_cast<float>((k + 0.5) / 255);
    float const below = std::nextafter(std::nextafter(middle, 0.0f), 0.0f);
    float const above = std::nextafter(std::nextafter(middle, 1.0f), 1.0f);
    auto const values = decode(encode(one_pixel(below, above, 0), "ppm")).values;
    CHECK(values[0] == float(k));
    CHECK(values[1] == float(k + 1));
  }
}

TEST_CASE("float formats store every value as it is, the first row at the top", "[unit][image]") {
  Image image = sample_image();
  image.pixel(3, 2)[0] = 1e30f;
  image.pixel(3, 2)[1] = -2.5f;
  image.pixel(3, 2)[2] = infinity;
  for (char const* const format : {"exr", "pfm"}) {
    DecodedImage const decoded = decode(encode(image, format));
    REQUIRE(decoded.width == image.width());
    REQUIRE(decoded.height == image.height());
    CHECK(decoded.values == image.data());
  }
}

TEST_CASE("PNG stores alpha beside straight colours", "[unit][image]") {
  Image image = one_pixel(0.2f, 0.4f, 1);
  image.alpha() = {0.6f};
  for (int const bits : {8, 16}) {
    float const max = bits == 8 ? 255.0f : 65535.0f;
    DecodedImage const decoded = decode(encode(image, "png", with_bits(bits)));
    CHECK(decoded.values == std::vector<float>{0.2f * max, 0.4f * max, max});
    CHECK(decoded.alpha == std::vector<float>{0.6f * max});
  }
}

TEST_CASE("a film of all planes becomes one OpenEXR file, a channel each", "[unit][image]") {
  PlaneSet planes;
  for (std::size_t i = 0; i < plane_count; ++i) planes.add(FilmPlane(i));
  Film film({7, 5, 3, 2}, planes);
  float next = 0.25f;
  std::uint32_t number = 0xfffffff0u;
  for (FilmPlane const plane : planes.list()) {
    for (float& value : film.floats(plane)) value = next++;
    for (std::uint32_t& value : film.numbers(plane)) value = number++;
  }
  film.set_end(1);
  std::string const bytes = image_format_named("exr").encode_film(film, {});
  for (FilmPlane const plane : planes.list()) {
    PlaneInfo const& info = info_of(plane);
    INFO(info.name);
    for (std::size_t c = 0; c < info.channels.size(); ++c) {
      std::string const channel(info.channels[c]);
      if (info.is_number) {
        CHECK(std::ranges::equal(decode_exr_numbers(bytes, channel.c_str()), film.numbers(plane)));
        continue;
      }
      auto const stored = decode_exr_floats(bytes, channel.c_str());
      REQUIRE(stored.size() == 6);
      for (int i = 0; i < 6; ++i) CHECK(stored[std::size_t(i)] == film.value(plane, i % 3, i / 3, int(c)));
    }
  }
}

TEST_CASE("PFM stores a plane of one channel as Pf", "[unit][image]") {
  Film film({0, 0, 2, 2}, {FilmPlane::depth});
  std::ranges::copy(std::vector<float>{1, 2, 3, infinity}, film.floats(FilmPlane::depth).begin());
  film.set_end(1);
  std::string const bytes = image_format_named("pfm").encode_film(film, {});
  CHECK(bytes.substr(0, 3) == "Pf\n");
  CHECK(decode(bytes).values == std::vector<float>{1, 1, 1, 2, 2, 2, 3, 3, 3, infinity, infinity, infinity});
}

TEST_CASE("JPEG keeps colours and places, and quality has its effect", "[unit][image]") {
  Image image(Resolution{64, 32});
  for (int y = 0; y < 32; ++y) {
    for (int x = 0; x < 64; ++x) {
      image.pixel(x, y)[0] = float(x) / 63;
      image.pixel(x, y)[1] = float(y) / 31;
      image.pixel(x, y)[2] = x < 32 ? 0.0f : 1.0f;
    }
  }
  ImageEncoding encoding;
  std::string const fine = encode(image, "jpg", encoding);
  encoding.jpeg_quality = 10;
  CHECK(encode(image, "jpg", encoding).size() < fine.size());
  DecodedImage const decoded = decode(fine);
  REQUIRE(decoded.width == 64);
  REQUIRE(decoded.height == 32);
  double sum = 0;
  for (std::size_t i = 0; i < image.data().size(); ++i)
    sum += std::abs(double(decoded.values[i]) - 255.0 * double(image.data()[i]));
  CHECK(sum / double(image.data().size()) < 2.0);
  // Chroma is stored for each pixel: the blue edge stays sharp.
  CHECK(decoded.at(31, 16, 2) < 40);
  CHECK(decoded.at(32, 16, 2) > 215);
}

TEST_CASE("the same picture gives the same bytes", "[unit][image]") {
  Image const image = sample_image();
  for (ImageFormat const& format : image_formats()) CHECK(encode(image, format.name) == encode(image, format.name));
}

TEST_CASE("single pixels and very long rows", "[unit][image]") {
  for (ImageFormat const& format : image_formats()) {
    for (Resolution const size : {Resolution{1, 1}, Resolution{1, 60000}, Resolution{60000, 1}}) {
      DecodedImage const decoded = decode(encode(Image(size), format.name));
      CHECK(decoded.width == size.width);
      CHECK(decoded.height == size.height);
    }
  }
}

TEST_CASE("formats are found by extension in any case, and by name", "[unit][image]") {
  CHECK(image_format_for("a/b.c/picture.PNG").name == "png");
  CHECK(image_format_for("x.jpeg").name == "jpg");
  CHECK(image_format_for("x.JPG").name == "jpg");
  CHECK(image_format_for("x.exr").max_planes == plane_count);
  CHECK(find_image_format("x.bmp") == nullptr);
  CHECK(find_image_format("png") == nullptr);
  CHECK(find_image_format("folder.png/x") == nullptr);
  CHECK_THROWS_WITH(image_format_for("x.bmp"),
                    contains_text("'.bmp'") && contains_text(".png, .ppm, .jpg, .jpeg, .exr, .pfm"));
  CHECK_THROWS_WITH(image_format_for("picture"), contains_text("no extension") && contains_text(".exr"));
  CHECK_THROWS_WITH(image_format_named("gif"), contains_text("'gif'") && contains_text("png, ppm, jpg, exr, pfm"));
  try {
    image_format_named("");
    FAIL("nothing was thrown");
  } catch (Error const& error) {
    CHECK(error.kind() == ErrorKind::usage);
  }
}

namespace {

class BytesInMemory final : public ByteSink {
 public:
  void write(std::string_view bytes) override {
    if (bytes_.size() < position_ + bytes.size()) bytes_.resize(position_ + bytes.size());
    bytes_.replace(position_, bytes.size(), bytes);
    position_ += bytes.size();
  }
  void seek(std::uint64_t position) override { position_ = position; }
  std::string const& bytes() const { return bytes_; }

 private:
  std::string bytes_;
  std::size_t position_ = 0;
};

/// Rows of a picture; `first` counts from its top.
Image rows_of(Image const& image, int first, int count) {
  std::size_t const width = std::size_t(image.width());
  auto const part = [&](std::vector<float> const& values, std::size_t channels) {
    auto const begin = values.begin() + std::ptrdiff_t(channels * width * std::size_t(first));
    return std::vector<float>(begin, begin + std::ptrdiff_t(channels * width * std::size_t(count)));
  };
  Image rows({image.width(), count}, part(image.data(), 3));
  if (!image.alpha().empty()) rows.alpha() = part(image.alpha(), 1);
  return rows;
}

constexpr int band_heights[] = {1, 5, 16, 1};  // of 23 rows; OpenEXR packs 16

template <class Rows, class Encoder>
void add_in_bands(Encoder& encoder, Rows const& rows) {
  int first = 0;
  for (int const height : band_heights) {
    encoder.add(rows(first, height));
    first += height;
  }
  encoder.finish();
}

}  // namespace

TEST_CASE("a picture that is encoded in bands has the bytes of the whole", "[unit][image]") {
  Image image = sample_image();
  for (bool const has_alpha : {false, true}) {
    if (has_alpha) image.alpha().assign(37 * 23, 0.25f);
    for (char const* const name : {"png", "ppm"}) {
      for (int const bits : {8, 16}) {
        for (bool const is_text : {false, true}) {
          ImageEncoding encoding = with_bits(bits);
          encoding.ppm_ascii = is_text;
          encoding.fingerprint = "0123456789abcdef";
          ImageFormat const& format = image_format_named(name);
          BytesInMemory sink;
          auto const encoder = format.begin(image.size(), has_alpha, encoding, sink);
          add_in_bands(*encoder, [&](int first, int height) { return rows_of(image, first, height); });
          INFO(name << ", " << bits << " bits, alpha " << has_alpha);
          CHECK(sink.bytes() == format.encode(image, encoding));
        }
      }
    }
  }
  CHECK(!image_format_named("jpg").begin);
}

TEST_CASE("planes that are encoded in bands have the bytes of the whole", "[unit][image]") {
  PlaneSet const all{FilmPlane::radiance, FilmPlane::alpha, FilmPlane::depth, FilmPlane::object};
  std::mt19937 random(3);
  std::uniform_real_distribution<float> value(0, 9);
  Film film = Film::of_samples({0, 0, 37, 23}, all, {0, 3});
  for (FilmPlane const plane : all.list()) {
    for (float& v : film.floats(plane)) v = value(random);
    for (std::uint32_t& v : film.numbers(plane)) v = std::uint32_t(random() % 1000);
  }
  auto const rows_of_film = [&](int first, int height) {
    Film rows = Film::of_samples({0, first, 37, height}, film.planes(), {0, 3});
    auto const to = rows.arrays(), from = film.arrays();
    for (std::size_t i = 0; i < to.size(); ++i) {
      std::size_t const row = from[i].size() / 23;
      std::copy_n(from[i].begin() + std::ptrdiff_t(row * std::size_t(first)), to[i].size(), to[i].begin());
    }
    return rows;
  };
  auto const check = [&](char const* name) {
    ImageFormat const& format = image_format_named(name);
    ImageEncoding encoding;
    encoding.fingerprint = "0123456789abcdef";
    BytesInMemory sink;
    auto const encoder = format.begin_film(film.size(), film.planes(), encoding, sink);
    add_in_bands(*encoder, rows_of_film);
    INFO(name);
    CHECK(sink.bytes() == format.encode_film(film, encoding));
  };
  check("exr");
  for (FilmPlane const plane : {FilmPlane::object, FilmPlane::depth, FilmPlane::radiance}) {
    Film const whole = film;
    film.keep({plane});
    check("pfm");
    film = whole;
  }
}

TEST_CASE("what a format cannot store is the caller's mistake", "[image_io]") {
  Image const good({4, 3});
  Image moved = good, few = good, alpha = good;
  Image const taken = std::move(moved);
  CHECK(taken.width() == 4);
  CHECK(moved.width() == 0);  // NOLINT(bugprone-use-after-move): that is what is tested
  few.data().pop_back();
  alpha.alpha().resize(1);
  ImageEncoding seven, deep, poor;
  seven.bits = 7;
  deep.bits = 16;
  poor.jpeg_quality = 0;
  for (char const* const name : {"png", "ppm", "jpg"}) {
    auto const encode = image_format_named(name).encode;
    CHECK_NOTHROW(encode(good, {}));
    for (Image const* const image : {&moved, &few, &alpha}) CHECK_THROWS_AS(encode(*image, {}), std::invalid_argument);
    for (auto const& encoding : {seven, poor}) CHECK_THROWS_AS(encode(good, encoding), std::invalid_argument);
  }
  CHECK_THROWS_AS(image_format_named("jpg").encode(good, deep), std::invalid_argument);
  CHECK_THROWS_AS(image_format_named("jpg").encode(Image({65501, 1}), {}), std::invalid_argument);

  PlaneSet const both{FilmPlane::radiance, FilmPlane::depth};
  auto const encode = image_format_named("exr").encode_film;
  CHECK_NOTHROW(encode(Film({0, 0, 4, 3}, both, 0), {}));
  CHECK_THROWS_AS(encode(Film({0, 0, 4, 3}, both, 16), {}), std::invalid_argument);
  CHECK_THROWS_AS(encode(Film({0, 0, 4, 3}, PlaneSet{}, 0), {}), std::invalid_argument);
  CHECK_THROWS_AS(encode(Film(), {}), std::invalid_argument);
  CHECK_THROWS_AS(image_format_named("pfm").encode_film(Film({0, 0, 4, 3}, both, 0), {}), std::invalid_argument);
}
