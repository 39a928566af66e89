#include <turbojpeg.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "io/image/decode.hpp"
#include "io/image/decode_all.hpp"
#include "support/catch.hpp"
#include "support/encode_png.hpp"

using namespace lichtraum;

namespace {

std::string progressive_jpeg() {
  std::vector<unsigned char> pixels(16 * 16 * 3);
  for (std::size_t i = 0; i < pixels.size(); ++i) pixels[i] = static_cast<unsigned char>(i * 37);
  std::unique_ptr<void, int (*)(tjhandle)> const encoder(tjInitCompress(), tjDestroy);
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  REQUIRE(tjCompress2(encoder.get(), pixels.data(), 16, 0, 16, TJPF_RGB, &bytes, &size, TJSAMP_444, 90,
                      TJFLAG_PROGRESSIVE) == 0);
  std::string const text(reinterpret_cast<char const*>(bytes), size);
  tjFree(bytes);
  return text;
}

/// The same with its first scan again and again.
std::string with_scans(std::string const& jpeg, int more) {
  std::size_t const begin = jpeg.find("\xff\xda"), end = jpeg.find("\xff\xc4", begin);
  REQUIRE(end != std::string::npos);
  std::string repeated;
  for (int i = 0; i < more; ++i) repeated += jpeg.substr(begin, end - begin);
  return jpeg.substr(0, end) + repeated + jpeg.substr(end);
}

}  // namespace

TEST_CASE("pictures are halved until they fit, to one pixel at the least", "[unit][image]") {
  std::string reason;
  for (auto const& [largest, width] : {std::pair(0, 1), std::pair(-5, 1), std::pair(1, 1), std::pair(8, 8)}) {
    auto const image = decode_image(progressive_jpeg(), largest, TexelContent::data, reason);
    REQUIRE(image);
    CHECK(image->width <= width);
  }
}

TEST_CASE("what is halved keeps its last row and column, and takes the memory that is foretold", "[unit][image]") {
  // Red on the right and below, five pixels each way.
  std::vector<std::array<std::uint8_t, 4>> pixels;
  for (int i = 0; i < 25; ++i) {
    bool const is_last = i % 5 == 4 || i / 5 == 4;
    pixels.push_back({std::uint8_t(is_last ? 255 : 0), 0, 0, 255});
  }
  std::string const png = test::encode_png(5, 5, pixels);
  std::string reason;
  auto const image = decode_image(png, 4, TexelContent::data, reason);
  REQUIRE(image);
  CHECK(image->width == 3);
  CHECK(image->height == 3);
  CHECK(image->rgba[4 * 2] == 255);
  CHECK(image->rgba[4 * 6] == 255);
  CHECK(image->rgba[0] == 0);
  for (int const largest : {8, 4, 2, 1}) {
    CHECK(decoded_size(png, largest).bytes() == decode_image(png, largest, TexelContent::data, reason)->rgba.size());
    CHECK(decoded_size(progressive_jpeg(), largest).bytes() ==
          decode_image(progressive_jpeg(), largest, TexelContent::data, reason)->rgba.size());
  }
  CHECK(decoded_size("no picture", 8) == ImageSize{});
  CHECK(decoded_size(png.substr(0, 20), 8) == ImageSize{});
}

namespace {

std::string png_of(int width, int height) {
  return test::encode_png(width, height,
                          std::vector<std::array<std::uint8_t, 4>>(std::size_t(width) * std::size_t(height)));
}

std::vector<ImageJob> jobs_of(std::vector<std::string> const& files) {
  std::vector<ImageJob> jobs(files.size());
  for (std::size_t i = 0; i < files.size(); ++i) {
    jobs[i].bytes = files[i];
    jobs[i].is_wanted = true;
  }
  return jobs;
}

std::vector<int> widths_of(std::vector<ImageJob> const& jobs) {
  std::vector<int> widths;
  for (ImageJob const& job : jobs) widths.push_back(job.image ? job.image->width : 0);
  return widths;
}

}  // namespace

TEST_CASE("the largest pictures are halved until all fit, the same ones however many threads decode them",
          "[unit][image]") {
  // 4096, 16384, 16384, 1024 and 64 bytes; what is not wanted, or cannot be had, takes none.
  std::vector<std::string> const files{png_of(32, 32), png_of(64, 64), png_of(64, 64),
                                       png_of(16, 16), png_of(4, 4),   png_of(64, 64)};
  auto const widths = [&](std::uint64_t max_bytes, int max_size = 64) {
    std::vector<ImageJob> jobs = jobs_of(files);
    jobs.back().is_wanted = false;
    std::string const note = decode_images(jobs, max_size, max_bytes);
    std::vector<int> found = widths_of(jobs);
    CHECK(note.empty() == (found == std::vector{std::min(32, max_size), max_size, max_size, 16, 4, 0}));
    std::uint64_t sum = 0;
    for (ImageJob const& job : jobs) {
      CHECK(job.reason.empty());
      if (job.image) sum += job.image->rgba.size();
    }
    CHECK(sum <= std::max<std::uint64_t>(max_bytes, 20));  // five pixels are the least
    return found;
  };
  CHECK(widths(37952) == std::vector{32, 64, 64, 16, 4, 0});
  CHECK(widths(37951) == std::vector{32, 64, 32, 16, 4, 0});  // of two that are as large the last
  CHECK(widths(25664) == std::vector{32, 64, 32, 16, 4, 0});
  CHECK(widths(25663) == std::vector{32, 32, 32, 16, 4, 0});
  CHECK(widths(10304) == std::vector{32, 32, 16, 16, 4, 0});
  CHECK(widths(13376, 32) == std::vector{32, 32, 32, 16, 4, 0});  // --max-texture first
  CHECK(widths(1) == std::vector{1, 1, 1, 1, 1, 0});

  std::vector<ImageJob> jobs = jobs_of(files);
  CHECK_THAT(decode_images(jobs, 64, 42048), contains_text("1 of the pictures are halved, the largest first"));
}

TEST_CASE("pictures of half a gigabyte are there on every machine, and of two on none", "[unit][image]") {
  CHECK(max_picture_bytes() >= std::uint64_t(1) << 29);
  CHECK(max_picture_bytes() <= std::uint64_t(1) << 31);
}

TEST_CASE("pictures beyond what can be decoded in good time are left out by their order", "[unit][image]") {
  // A header that says 8192 x 8192, 256 MiB, over data that is not so: 128 of them are too many for one more.
  std::string claim = png_of(5, 5);
  claim.replace(16, 8, std::string("\0\0\x20\0\0\0\x20\0", 8));
  std::vector<std::string> files(129, claim);
  files.push_back(png_of(5, 5));
  std::vector<ImageJob> jobs = jobs_of(files);
  CHECK(decode_images(jobs, 16) == "");
  CHECK(jobs[127].reason.find("can be read") == std::string::npos);
  CHECK_THAT(jobs[128].reason, contains_text("8589934592 can be read"));
  CHECK_THAT(jobs[129].reason, contains_text("8589934592 can be read"));

  claim.replace(16, 8, std::string("\0\0\x40\0\0\0\x20\0", 8));
  std::string reason;
  CHECK_FALSE(decode_image(claim, 16, TexelContent::data, reason));
  CHECK_THAT(reason, contains_text("it has 16384 x 8192 pixels"));
}

TEST_CASE("a JPEG texture that goes over its pixels again and again is refused", "[unit][image]") {
  std::string const jpeg = progressive_jpeg();
  std::string reason;
  REQUIRE(decode_image(jpeg, 64, TexelContent::data, reason));
  CHECK(decode_image(with_scans(jpeg, 300), 64, TexelContent::data, reason));
  CHECK_FALSE(decode_image(with_scans(jpeg, 600), 64, TexelContent::data, reason));
  CHECK_THAT(reason, contains_text("500 scans"));
}

namespace {

/// A grey JPEG (128 everywhere) of one unit of blocks, where brightness has `across` x `down` of them to one of each
/// colour.
std::string grey_jpeg(int across, int down) {
  using namespace std::string_literals;
  auto const segment = [](char marker, std::string const& data) {
    return "\xff"s + marker + '\0' + char(data.size() + 2) + data;
  };
  std::string const ones(64, '\1');  // what values are divided by
  char const sampling = char(across << 4 | down);
  std::string const components = "\1"s + sampling + "\0\2\x11\0\3\x11\0"s;
  std::string const size = "\0"s + char(8 * down) + "\0"s + char(8 * across);
  // One code of one bit in each table: no change, and no more of this block. A bit of each is two zeros a block.
  std::string const code = "\1"s + std::string(15, '\0') + '\0';
  std::size_t const bits = 2 * std::size_t(across * down + 2);
  std::string data(bits / 8 + 1, '\0');
  data.back() = char(0xFF >> bits % 8);  // filled up with ones
  if (data.back() == '\xff') data += '\0';
  return "\xff\xd8"s + segment('\xdb', '\0' + ones) + segment('\xc0', '\x08' + size + '\3' + components) +
         segment('\xc4', '\0' + code) + segment('\xc4', '\x10' + code) + segment('\xda', "\3\1\0\2\0\3\0\0\x3f\0"s) +
         data + "\xff\xd9"s;
}

}  // namespace

TEST_CASE("JPEG textures may share colours between any number of pixels", "[unit][image]") {
  for (auto const& [across, down] :
       {std::pair(1, 1), std::pair(2, 2), std::pair(1, 4), std::pair(4, 2), std::pair(3, 1)}) {
    INFO(across << "x" << down);
    std::string const jpeg = grey_jpeg(across, down);
    std::string reason;
    CHECK(decoded_size(jpeg, 64).width == 8 * across);
    auto const image = decode_image(jpeg, 64, TexelContent::data, reason);
    INFO(reason);
    REQUIRE(image);
    CHECK(image->width == 8 * across);
    CHECK(image->height == 8 * down);
    for (std::size_t i = 0; i < image->rgba.size(); ++i) REQUIRE(image->rgba[i] == (i % 4 == 3 ? 255 : 128));
  }
  std::string reason;
  CHECK(!decode_image(grey_jpeg(1, 4).substr(0, 60), 64, TexelContent::data, reason));
  CHECK(reason != "");
}

TEST_CASE("JPEG textures in printers' inks are shown in the colours that these leave", "[unit][image]") {
  // As Adobe's programs write them: 255 is no ink. Red; black by the black ink alone; half grey.
  std::vector<unsigned char> pixels;
  for (int i = 0; i < 3; ++i) {
    unsigned char const inks[3][4] = {{255, 0, 0, 255}, {255, 255, 255, 0}, {255, 255, 255, 128}};
    for (int k = 0; k < 16 * 16; ++k) pixels.insert(pixels.end(), inks[i], inks[i] + 4);
  }
  std::unique_ptr<void, int (*)(tjhandle)> const encoder(tjInitCompress(), tjDestroy);
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  REQUIRE(tjCompress2(encoder.get(), pixels.data(), 16, 0, 48, TJPF_CMYK, &bytes, &size, TJSAMP_444, 100, 0) == 0);
  std::string const jpeg(reinterpret_cast<char const*>(bytes), size);
  tjFree(bytes);
  std::string reason;
  auto const image = decode_image(jpeg, 64, TexelContent::data, reason);
  INFO(reason);
  REQUIRE(image);
  std::array<int, 4> const expected[] = {{255, 0, 0, 255}, {0, 0, 0, 255}, {128, 128, 128, 255}};
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t c = 0; c < 4; ++c) {
      int const found = image->rgba[4 * (16 * row + 8) * 16 + c];
      CHECK(std::abs(found - expected[row][c]) <= 3);  // JPEG is not exact
    }
  }
}

TEST_CASE("colours that are halved keep their light, data their mean", "[unit][image]") {
  std::vector<std::array<std::uint8_t, 4>> const pixels = {
      {0, 10, 200, 0}, {255, 10, 200, 255}, {255, 10, 200, 0}, {0, 10, 200, 255}};
  std::string const png = test::encode_png(2, 2, pixels);
  std::string reason;
  auto const color = decode_image(png, 1, TexelContent::color, reason),
             data = decode_image(png, 1, TexelContent::data, reason);
  REQUIRE((color && data));
  CHECK(color->rgba == std::vector<std::uint8_t>{188, 10, 200, 128});  // sRGB's 0.5 is 187.5 of 255
  CHECK(data->rgba == std::vector<std::uint8_t>{128, 10, 200, 128});
}
