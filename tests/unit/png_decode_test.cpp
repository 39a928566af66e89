#include <png.h>

#include <cstdint>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "io/image/decode.hpp"
#include "support/catch.hpp"

using namespace lichtraum;

namespace {

constexpr int largest = std::numeric_limits<int>::max();

/// A PNG of any kind, to decode. Rows are as libpng takes them: packed, and big endian.
struct PngOf {
  int width, height;
  int bits;
  int color_type;
  std::vector<std::uint8_t> bytes;
  int interlacing = PNG_INTERLACE_NONE;
  std::function<void(png_structp, png_infop)> add_chunks = nullptr;
};

std::string encoded(PngOf const& source) {
  auto const fail = [](png_structp, char const* message) { throw std::runtime_error(message); };
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, fail, nullptr);
  png_infop info = png_create_info_struct(png);
  std::string file;
  auto const append = [](png_structp p, png_bytep data, std::size_t size) {
    static_cast<std::string*>(png_get_io_ptr(p))->append(reinterpret_cast<char const*>(data), size);
  };
  png_set_write_fn(png, &file, append, [](png_structp) {});
  png_set_IHDR(png, info, png_uint_32(source.width), png_uint_32(source.height), source.bits, source.color_type,
               source.interlacing, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  if (source.add_chunks) source.add_chunks(png, info);
  png_write_info(png, info);
  std::vector<std::uint8_t> bytes = source.bytes;
  std::vector<png_bytep> rows;
  for (int y = 0; y < source.height; ++y)
    rows.push_back(bytes.data() + std::size_t(y) * (bytes.size() / std::size_t(source.height)));
  png_write_image(png, rows.data());
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  return file;
}

using Bytes = std::vector<std::uint8_t>;

Bytes decoded(PngOf const& source) {
  std::string reason;
  auto const image = decode_image(encoded(source), largest, TexelContent::data, reason);
  INFO(reason);
  REQUIRE(image);
  CHECK(image->width == source.width);
  CHECK(image->height == source.height);
  return image->rgba;
}

/// 8 x 8 pixels, each another color.
PngOf colorful(int interlacing) {
  PngOf source{8, 8, 8, PNG_COLOR_TYPE_RGBA, {}, interlacing};
  for (int i = 0; i < 4 * 64; ++i) source.bytes.push_back(std::uint8_t(i));
  return source;
}

}  // namespace

TEST_CASE("a PNG's numbers are taken as they are, whatever it says of its colors", "[unit][image]") {
  PngOf source{2, 1, 8, PNG_COLOR_TYPE_RGB, {128, 0, 255, 1, 2, 3}};
  Bytes const expected{128, 0, 255, 255, 1, 2, 3, 255};
  CHECK(decoded(source) == expected);
  for (double const gamma : {1.0, 1 / 1.8, 0.45455}) {
    INFO(gamma);
    source.add_chunks = [&](png_structp png, png_infop info) { png_set_gAMA(png, info, gamma); };
    CHECK(decoded(source) == expected);
  }
  source.add_chunks = [](png_structp png, png_infop info) { png_set_sRGB_gAMA_and_cHRM(png, info, 0); };
  CHECK(decoded(source) == expected);
  source.add_chunks = [](png_structp png, png_infop info) {
    png_color_8 const fewer_bits{4, 4, 4, 0, 0};
    png_set_sBIT(png, info, &fewer_bits);
    png_color_16 const background{0, 9, 9, 9, 9};
    png_set_bKGD(png, info, &background);
  };
  CHECK(decoded(source) == expected);
}

TEST_CASE("of 16 bits the upper eight count, rounded", "[unit][image]") {
  // 0x8080 is 128, and 0x01FF nearer to 2 than to 1.
  CHECK(decoded({2, 1, 16, PNG_COLOR_TYPE_GRAY, {0x80, 0x80, 0x01, 0xFF}}) == Bytes{128, 128, 128, 255, 2, 2, 2, 255});
  CHECK(decoded({1, 1, 16, PNG_COLOR_TYPE_RGB, {0x80, 0x80, 0x01, 0xFF, 0xFF, 0xFF}}) == Bytes{128, 2, 255, 255});
  CHECK(decoded({1, 1, 16, PNG_COLOR_TYPE_RGBA, {0x80, 0x80, 0x01, 0xFF, 0xFF, 0xFF, 0x40, 0x40}}) ==
        Bytes{128, 2, 255, 64});
  CHECK(decoded({1, 1, 16, PNG_COLOR_TYPE_GRAY_ALPHA, {0x80, 0x80, 0x40, 0x40}}) == Bytes{128, 128, 128, 64});
}

TEST_CASE("palettes, few bits of grey, and colors that are transparent", "[unit][image]") {
  PngOf palette{3, 1, 2, PNG_COLOR_TYPE_PALETTE, {0b00'01'10'00}};
  palette.add_chunks = [](png_structp png, png_infop info) {
    png_color const colors[]{{1, 2, 3}, {128, 0, 255}, {7, 8, 9}};
    png_set_PLTE(png, info, colors, 3);
    png_byte const alphas[]{0, 77};
    png_set_tRNS(png, info, alphas, 2, nullptr);
  };
  CHECK(decoded(palette) == Bytes{1, 2, 3, 0, 128, 0, 255, 77, 7, 8, 9, 255});

  PngOf grey{4, 1, 2, PNG_COLOR_TYPE_GRAY, {0b00'01'10'11}};
  CHECK(decoded(grey) == Bytes{0, 0, 0, 255, 85, 85, 85, 255, 170, 170, 170, 255, 255, 255, 255, 255});
  grey.add_chunks = [](png_structp png, png_infop info) {
    png_color_16 const transparent{0, 0, 0, 0, 2};
    png_set_tRNS(png, info, nullptr, 0, &transparent);
  };
  CHECK(decoded(grey) == Bytes{0, 0, 0, 255, 85, 85, 85, 255, 170, 170, 170, 0, 255, 255, 255, 255});

  // Of 16 bits all count: the neighbor is not transparent.
  PngOf fine{2, 1, 16, PNG_COLOR_TYPE_GRAY, {0x80, 0x80, 0x80, 0x81}};
  fine.add_chunks = [](png_structp png, png_infop info) {
    png_color_16 const transparent{0, 0, 0, 0, 0x8080};
    png_set_tRNS(png, info, nullptr, 0, &transparent);
  };
  CHECK(decoded(fine) == Bytes{128, 128, 128, 0, 128, 128, 128, 255});
}

TEST_CASE("an interlaced PNG is the same picture", "[unit][image]") {
  PngOf const plain = colorful(PNG_INTERLACE_NONE);
  CHECK(decoded(plain) == plain.bytes);
  CHECK(decoded(colorful(PNG_INTERLACE_ADAM7)) == plain.bytes);
}

TEST_CASE("a PNG that is cut off or damaged is refused with a reason", "[unit][image]") {
  std::string const file = encoded(colorful(PNG_INTERLACE_NONE));
  auto const refusal = [](std::string const& bytes) {
    std::string reason;
    CHECK_FALSE(decode_image(bytes, largest, TexelContent::data, reason));
    return reason;
  };
  std::size_t const data = file.find("IDAT") + 4, end = file.find("IEND") - 4;
  CHECK_THAT(refusal(file.substr(0, 20)), contains_text("the header gives no size"));
  for (std::size_t const length : {std::size_t(30), data - 3, data + 1, end - 5}) {
    INFO(length);
    CHECK_THAT(refusal(file.substr(0, length)), contains_text("too short"));
  }
  std::string damaged = file;
  damaged[end - 1] ^= 1;
  CHECK_THAT(refusal(damaged), contains_text("CRC error"));
  // Another chunk first, where the size is looked for: it could claim less than there is.
  std::string const signature = file.substr(0, 8), header = file.substr(8, 25), rest = file.substr(33);
  std::string const claim(
      "\0\0\0\x0d"
      "noNe\0\0\0\1\0\0\0\1\x08\6\0\0\0\x8e\x7c\x5c\x42",
      25);
  CHECK_FALSE(refusal(signature + claim + header + rest).empty());
}
