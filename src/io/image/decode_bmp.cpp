#include "io/image/decode_bmp.hpp"

#include <algorithm>
#include <bit>
#include <optional>
#include <vector>

#include "io/image/bitmap.hpp"

namespace lichtraum {
namespace {

constexpr std::size_t file_header_bytes = 14;
constexpr std::size_t old_header_bytes = 12;  // OS/2's
constexpr std::size_t info_header_bytes = 40;
constexpr std::uint32_t uncompressed = 0, with_masks = 3, with_alpha_mask = 6;

struct Masks {
  std::uint32_t red = 0, green = 0, blue = 0, alpha = 0;
};

struct BmpHeader {
  bool is_old = false;
  ImageSize size;
  bool is_from_top = false;
  std::size_t bits = 0;
  std::uint32_t compression = uncompressed;
  Masks masks;
  std::size_t palette_at = 0, color_count = 0;
  std::size_t data_at = 0;

  std::size_t color_bytes() const { return is_old ? 3 : 4; }
  std::size_t used_row_bytes() const { return (std::size_t(size.width) * bits + 7) / 8; }
  std::size_t row_bytes() const { return (std::size_t(size.width) * bits + 31) / 32 * 4; }  // rows are padded
};

/// Nothing where it is cut off or none that is known. Sizes may still be 0 or huge.
std::optional<BmpHeader> read_bmp_header(std::string_view bytes) {
  if (bytes.size() < file_header_bytes + old_header_bytes) return std::nullopt;
  auto const number = [&](std::size_t first, std::size_t count) { return little_endian(bytes, first, count); };
  BmpHeader header;
  header.data_at = number(10, 4);
  std::size_t const length = number(14, 4);
  header.is_old = length == old_header_bytes;
  header.palette_at = file_header_bytes + length;
  if (header.is_old) {
    header.size = {number(18, 2), number(20, 2)};
    header.bits = number(24, 2);
  } else {
    if (length < info_header_bytes || bytes.size() < file_header_bytes + info_header_bytes) return std::nullopt;
    auto const height = std::int64_t(std::int32_t(number(22, 4)));
    header.size = {std::int32_t(number(18, 4)), height < 0 ? -height : height};
    header.is_from_top = height < 0;
    header.bits = number(28, 2);
    header.compression = number(30, 4);
    header.color_count = number(46, 4);
  }
  if (header.bits == 16) header.masks = {0x7C00, 0x3E0, 0x1F, 0};
  if (header.bits == 32) header.masks = {0xFF0000, 0xFF00, 0xFF, 0xFF000000};
  if (header.compression == with_masks || header.compression == with_alpha_mask) {
    // In longer headers, or behind this one.
    constexpr std::size_t masks_at = file_header_bytes + info_header_bytes;
    bool const has_alpha = length >= info_header_bytes + 16 || header.compression == with_alpha_mask;
    std::size_t const end = masks_at + (has_alpha ? 16 : 12);
    if (bytes.size() < end) return std::nullopt;
    header.masks = {number(masks_at, 4), number(masks_at + 4, 4), number(masks_at + 8, 4),
                    has_alpha ? number(masks_at + 12, 4) : 0};
    header.palette_at = std::max(header.palette_at, end);
  }
  if (header.bits <= 8) {
    std::size_t const all = std::size_t(1) << header.bits;
    if (header.color_count == 0 || header.color_count > all) header.color_count = all;
  }
  return header;
}

std::uint8_t masked_channel(std::uint32_t value, std::uint32_t mask, std::uint8_t without) {
  if (mask == 0) return without;
  int const shift = std::countr_zero(mask);
  return scaled_to_8((value & mask) >> shift, mask >> shift);
}

/// What is wrong, before any pixel is read; empty: nothing.
std::string fault_of_bmp(BmpHeader const& header, std::string_view bytes) {
  bool const has_masks = header.compression == with_masks || header.compression == with_alpha_mask;
  if (header.compression != uncompressed && !has_masks) return "compressed BMP pictures cannot be decoded";
  bool const is_known = header.bits == 1 || header.bits == 4 || header.bits == 8 || header.bits == 16 ||
                        header.bits == 24 || header.bits == 32;
  if (!is_known || (has_masks && header.bits < 16)) return "the BMP header is damaged";
  std::size_t const needed = header.row_bytes() * (std::size_t(header.size.height) - 1) + header.used_row_bytes();
  if (bytes.size() < header.data_at || bytes.size() - header.data_at < needed) return "the BMP data ends too early";
  return {};
}

class BmpReader {
 public:
  BmpReader(std::string_view bytes, BmpHeader const& header) : bytes_(bytes), header_(header) {
    if (header.bits > 8) return;
    std::size_t const end = bytes.size();
    for (std::size_t i = 0; i < header.color_count; ++i) {
      std::size_t const at = header.palette_at + i * header.color_bytes();
      if (at > end || end - at < header.color_bytes()) break;
      palette_.push_back(color_of_bgra(bytes, at, false));
    }
  }

  /// False where the palette lacks its colour. `row`: where it begins.
  bool pixel(std::size_t row, std::size_t x, Rgba8& color) const {
    std::size_t const bits = header_.bits;
    if (bits <= 8) {
      std::size_t const per_byte = 8 / bits;
      std::uint32_t const byte = little_endian(bytes_, row + x / per_byte, 1);
      std::size_t const number = byte >> (8 - bits * (x % per_byte + 1)) & ((1u << bits) - 1);
      if (number >= palette_.size()) return false;
      color = palette_[number];
    } else if (bits == 24) {
      color = color_of_bgra(bytes_, row + 3 * x, false);
    } else {
      std::uint32_t const value = little_endian(bytes_, row + bits / 8 * x, bits / 8);
      auto const& [red, green, blue, alpha] = header_.masks;
      color = {masked_channel(value, red, 0), masked_channel(value, green, 0), masked_channel(value, blue, 0),
               masked_channel(value, alpha, 255)};
    }
    return true;
  }

 private:
  std::string_view bytes_;
  BmpHeader const& header_;
  std::vector<Rgba8> palette_;
};

}  // namespace

bool is_bmp(std::string_view bytes) { return bytes.starts_with("BM"); }

ImageSize size_of_bmp(std::string_view bytes) {
  auto const header = read_bmp_header(bytes);
  return header ? header->size : ImageSize();
}

bool decode_bmp(std::string_view bytes, TextureImage& image, std::string& reason) {
  BmpHeader const header = read_bmp_header(bytes).value();  // as it gave a size
  reason = fault_of_bmp(header, bytes);
  if (!reason.empty()) return false;
  auto const width = std::size_t(header.size.width), height = std::size_t(header.size.height);
  image.rgba.resize(4 * width * height);
  BmpReader const reader(bytes, header);
  Rgba8 color{};
  auto out = image.rgba.begin();
  for (std::size_t y = 0; y < height; ++y) {
    std::size_t const row = header.data_at + (header.is_from_top ? y : height - 1 - y) * header.row_bytes();
    for (std::size_t x = 0; x < width; ++x) {
      if (!reader.pixel(row, x, color)) {
        reason = "the BMP data has a colour that its palette lacks";
        return false;
      }
      out = std::copy(color.begin(), color.end(), out);
    }
  }
  fill_empty_alpha(image);
  return true;
}

}  // namespace lichtraum
