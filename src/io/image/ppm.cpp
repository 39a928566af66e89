#include <fmt/format.h>

#include "io/image/encoders.hpp"
#include "io/image/quantize.hpp"

namespace lichtraum {
namespace {

std::string encode_text(Image const& image, int bits) {
  std::string text = fmt::format("P3\n{} {}\n{}\n", image.width(), image.height(), bits == 16 ? 65535 : 255);
  auto out = std::back_inserter(text);
  for (int y = 0; y < image.height(); ++y) {
    // One pixel a line: the format asks for lines of at most 70 characters.
    for (int x = 0; x < image.width(); ++x) {
      float const* p = image.pixel(x, y);
      auto const value = [&](int c) { return bits == 16 ? quantize<65535>(p[c]) : quantize<255>(p[c]); };
      fmt::format_to(out, "{} {} {}\n", value(0), value(1), value(2));
    }
  }
  return text;
}

}  // namespace

std::string encode_ppm(Image const& image, ImageEncoding const& encoding) {
  if (encoding.ppm_ascii) return encode_text(image, encoding.bits);
  bool const wide = encoding.bits == 16;
  std::string bytes = fmt::format("P6\n{} {}\n{}\n", image.width(), image.height(), wide ? 65535 : 255);
  std::size_t const header = bytes.size();
  std::size_t const count = image.data().size();
  bytes.resize(header + count * (wide ? 2 : 1));
  auto* const pixels = reinterpret_cast<unsigned char*>(bytes.data()) + header;
  wide ? quantize_16(image.data().data(), count, pixels) : quantize_8(image.data().data(), count, pixels);
  return bytes;
}

}  // namespace lichtraum
