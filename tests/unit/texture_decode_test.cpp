#include <turbojpeg.h>

#include <memory>
#include <vector>

#include "io/image/decode.hpp"
#include "support/catch.hpp"

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

TEST_CASE("a JPEG texture that goes over its pixels again and again is refused", "[unit][image]") {
  std::string const jpeg = progressive_jpeg();
  std::string reason;
  REQUIRE(decode_image(jpeg, 64, reason));
  CHECK(decode_image(with_scans(jpeg, 300), 64, reason));
  CHECK_FALSE(decode_image(with_scans(jpeg, 600), 64, reason));
  CHECK_THAT(reason, contains_text("500 scans"));
}
