#include <turbojpeg.h>

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
    auto const image = decode_image(progressive_jpeg(), largest, reason);
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
  auto const image = decode_image(png, 4, reason);
  REQUIRE(image);
  CHECK(image->width == 3);
  CHECK(image->height == 3);
  CHECK(image->rgba[4 * 2] == 255);
  CHECK(image->rgba[4 * 6] == 255);
  CHECK(image->rgba[0] == 0);
  for (int const largest : {8, 4, 2, 1}) {
    CHECK(decoded_bytes(png, largest) == decode_image(png, largest, reason)->rgba.size());
    CHECK(decoded_bytes(progressive_jpeg(), largest) == decode_image(progressive_jpeg(), largest, reason)->rgba.size());
  }
  CHECK(decoded_bytes("no picture", 8) == 0);
  CHECK(decoded_bytes(png.substr(0, 20), 8) == 0);
}

TEST_CASE("pictures are left out by their order, however many threads decode them", "[unit][image]") {
  std::string const png = test::encode_png(5, 5, std::vector<std::array<std::uint8_t, 4>>(25));
  // Headers that say 8192 x 8192 and 8192 x 4096, over data that is not so: 256 and 128 MB.
  auto const claiming = [&](char high) {
    std::string claims = png;
    claims.replace(16, 8, std::string("\0\0\x20\0\0\0", 6) + high + '\0');
    return claims;
  };
  std::vector<std::string> const files{claiming('\x20'), claiming('\x20'), claiming('\x10'), png};
  std::vector<ImageJob> jobs(files.size());
  for (std::size_t i = 0; i < files.size(); ++i) {
    jobs[i].bytes = files[i];
    jobs[i].is_wanted = true;
  }
  decode_images(jobs, 16384);
  CHECK_THAT(jobs[2].reason, contains_text("a smaller --max-texture helps"));
  CHECK_THAT(jobs[3].reason, contains_text("a smaller --max-texture helps"));
  CHECK(jobs[0].reason.find("--max-texture") == std::string::npos);
  CHECK(jobs[1].reason.find("--max-texture") == std::string::npos);
}

TEST_CASE("a JPEG texture that goes over its pixels again and again is refused", "[unit][image]") {
  std::string const jpeg = progressive_jpeg();
  std::string reason;
  REQUIRE(decode_image(jpeg, 64, reason));
  CHECK(decode_image(with_scans(jpeg, 300), 64, reason));
  CHECK_FALSE(decode_image(with_scans(jpeg, 600), 64, reason));
  CHECK_THAT(reason, contains_text("500 scans"));
}
