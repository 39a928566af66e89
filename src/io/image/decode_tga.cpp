#include "io/image/decode_tga.hpp"

#include <algorithm>

#include "io/image/bitmap.hpp"

namespace lichtraum {
namespace {

constexpr std::size_t tga_header_bytes = 18;
constexpr std::size_t most_in_a_packet = 128;

struct TgaHeader {
  bool has_palette, is_packed;
  int kind;  // 1: numbers of a palette's colours, 2: colours, 3: greys
  std::size_t first_color, color_count, color_bits;
  std::size_t width, height, bits;
  bool is_mirrored, is_from_top;
  std::size_t palette_at;

  explicit TgaHeader(std::string_view bytes) {
    auto const number = [&](std::size_t first, std::size_t count) { return little_endian(bytes, first, count); };
    has_palette = number(1, 1) == 1;
    is_packed = number(2, 1) >= 8;
    kind = int(number(2, 1)) - (is_packed ? 8 : 0);
    first_color = number(3, 2);
    color_count = has_palette ? number(5, 2) : 0;
    color_bits = number(7, 1);
    width = number(12, 2);
    height = number(14, 2);
    bits = number(16, 1);
    is_mirrored = (number(17, 1) & 0x10) != 0;
    is_from_top = (number(17, 1) & 0x20) != 0;
    palette_at = tga_header_bytes + number(0, 1);
  }

  std::size_t data_at() const { return palette_at + color_count * ((color_bits + 7) / 8); }
  std::size_t pixel_bytes() const { return (bits + 7) / 8; }
  std::size_t pixel_count() const { return width * height; }
  /// Of the data, at the least.
  std::size_t least_bytes() const {
    return is_packed ? (pixel_count() + most_in_a_packet - 1) / most_in_a_packet * (1 + pixel_bytes())
                     : pixel_count() * pixel_bytes();
  }
};

bool is_tga_color_size(std::size_t bits) { return bits == 15 || bits == 16 || bits == 24 || bits == 32; }

/// Of 15 or 16 bits five each; the sixteenth is no alpha that programs agree on.
Rgba8 tga_color(std::string_view bytes, std::size_t at, std::size_t bits) {
  if (bits >= 24) return color_of_bgra(bytes, at, bits == 32);
  std::uint32_t const value = little_endian(bytes, at, 2);
  return {scaled_to_8(value >> 10 & 31, 31), scaled_to_8(value >> 5 & 31, 31), scaled_to_8(value & 31, 31), 255};
}

class TgaReader {
 public:
  TgaReader(std::string_view bytes, TgaHeader const& header) : bytes_(bytes), header_(header), at_(header.data_at()) {}

  /// False, with a reason, where the data ends or makes no sense.
  bool read(TextureImage& image, std::string& reason) {
    std::size_t left = 0;  // of the packet
    bool is_repeated = false;
    Rgba8 color{};
    for (std::size_t i = 0; i < header_.pixel_count(); ++i) {
      bool const begins = header_.is_packed && left == 0;
      if (begins) {
        if (!has(1)) return ends(reason);
        std::uint32_t const packet = little_endian(bytes_, at_++, 1);
        is_repeated = packet >= most_in_a_packet;
        left = packet % most_in_a_packet + 1;
      }
      if (begins || !is_repeated) {
        if (!has(header_.pixel_bytes())) return ends(reason);
        if (!next(color)) {
          reason = "the TGA data has a colour that its palette lacks";
          return false;
        }
      }
      if (header_.is_packed) --left;
      std::copy(color.begin(), color.end(), image.rgba.begin() + std::ptrdiff_t(4 * place_of(i)));
    }
    return true;
  }

 private:
  bool has(std::size_t count) const { return bytes_.size() - at_ >= count; }
  static bool ends(std::string& reason) {
    reason = "the TGA data ends too early";
    return false;
  }

  /// The number of a pixel in rows from the top, from left to right.
  std::size_t place_of(std::size_t i) const {
    std::size_t const x = i % header_.width, y = i / header_.width;
    return (header_.is_from_top ? y : header_.height - 1 - y) * header_.width +
           (header_.is_mirrored ? header_.width - 1 - x : x);
  }

  bool next(Rgba8& color) {
    std::size_t const at = at_;
    at_ += header_.pixel_bytes();
    if (header_.kind == 2) {
      color = tga_color(bytes_, at, header_.bits);
    } else if (header_.kind == 3) {
      auto const grey = std::uint8_t(bytes_[at]);
      color = {grey, grey, grey, header_.bits == 16 ? std::uint8_t(bytes_[at + 1]) : std::uint8_t(255)};
    } else {
      std::size_t const number = little_endian(bytes_, at, header_.pixel_bytes());
      if (number < header_.first_color || number - header_.first_color >= header_.color_count) return false;
      std::size_t const size = (header_.color_bits + 7) / 8;
      color = tga_color(bytes_, header_.palette_at + (number - header_.first_color) * size, header_.color_bits);
    }
    return true;
  }

  std::string_view bytes_;
  TgaHeader const& header_;
  std::size_t at_;
};

}  // namespace

bool is_tga(std::string_view bytes) {
  if (bytes.size() < tga_header_bytes) return false;
  TgaHeader const header(bytes);
  bool const is_interleaved = (little_endian(bytes, 17, 1) & 0xC0) != 0;  // nobody writes that any more
  if (little_endian(bytes, 1, 1) > 1 || is_interleaved || header.width == 0 || header.height == 0) return false;
  if (header.has_palette && !is_tga_color_size(header.color_bits)) return false;
  switch (header.kind) {
    case 1:
      return header.color_count > 0 && (header.bits == 8 || header.bits == 16);
    case 2:
      return is_tga_color_size(header.bits);
    case 3:
      return header.bits == 8 || header.bits == 16;
    default:
      return false;
  }
}

ImageSize size_of_tga(std::string_view bytes) {
  TgaHeader const header(bytes);
  return {std::int64_t(header.width), std::int64_t(header.height)};
}

bool decode_tga(std::string_view bytes, TextureImage& image, std::string& reason) {
  TgaHeader const header(bytes);
  if (bytes.size() < header.data_at() || bytes.size() - header.data_at() < header.least_bytes()) {
    reason = "the TGA data ends too early";
    return false;
  }
  image.rgba.resize(4 * header.pixel_count());
  if (!TgaReader(bytes, header).read(image, reason)) return false;
  fill_empty_alpha(image);
  return true;
}

}  // namespace lichtraum
