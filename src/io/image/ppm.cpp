#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>

#include "io/image/encoders.hpp"
#include "io/image/quantize.hpp"

namespace lichtraum {
namespace {

class PpmRows final : public RowEncoder<Image> {
 public:
  PpmRows(Resolution const& size, ImageEncoding const& encoding, ByteSink& sink)
      : sink_(sink), is_text_(encoding.ppm_ascii), is_wide_(encoding.bits == 16) {
    sink_.write(
        fmt::format("{}\n{} {}\n{}\n", is_text_ ? "P3" : "P6", size.width, size.height, is_wide_ ? 65535 : 255));
  }

  void add(Image const& rows) override { is_text_ ? add_text(rows) : add_bytes(rows); }
  void finish() override {}

 private:
  void add_text(Image const& rows) {
    std::string text;
    auto out = std::back_inserter(text);
    for (int y = 0; y < rows.height(); ++y) {
      // One pixel a line: the format asks for lines of at most 70 characters.
      for (int x = 0; x < rows.width(); ++x) {
        float const* p = rows.pixel(x, y);
        auto const value = [&](int c) { return is_wide_ ? quantize<65535>(p[c]) : quantize<255>(p[c]); };
        fmt::format_to(out, "{} {} {}\n", value(0), value(1), value(2));
      }
    }
    sink_.write(text);
  }
  void add_bytes(Image const& rows) {
    // As much at a time as stays in the cache.
    std::array<unsigned char, 1 << 15> bytes;
    std::size_t const bytes_per_value = is_wide_ ? 2 : 1;
    std::span<float const> values = rows.data();
    while (!values.empty()) {
      auto const part = values.first(std::min(values.size(), bytes.size() / bytes_per_value));
      is_wide_ ? quantize_16(part.data(), part.size(), bytes.data())
               : quantize_8(part.data(), part.size(), bytes.data());
      sink_.write({reinterpret_cast<char const*>(bytes.data()), part.size() * bytes_per_value});
      values = values.subspan(part.size());
    }
  }

  ByteSink& sink_;
  bool is_text_;
  bool is_wide_;
};

}  // namespace

std::unique_ptr<RowEncoder<Image>> begin_ppm(Resolution const& size, bool /*has_alpha*/, ImageEncoding const& encoding,
                                             ByteSink& sink) {
  return std::make_unique<PpmRows>(size, encoding, sink);
}

std::string encode_ppm(Image const& image, ImageEncoding const& encoding) {
  check_encodable(image, encoding, "ppm");
  constexpr std::size_t header_size = 32;  // or less
  MemorySink sink(header_size + image.data().size() * (encoding.bits == 16 ? 2 : 1));
  PpmRows(image.size(), encoding, sink).add(image);
  return sink.take();
}

}  // namespace lichtraum
