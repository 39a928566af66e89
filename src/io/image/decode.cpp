#include "io/image/decode.hpp"

#include <fmt/format.h>
#include <turbojpeg.h>
#include <webp/decode.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/srgb.hpp"
#include "io/image/decode_bmp.hpp"
#include "io/image/decode_png.hpp"
#include "io/image/decode_tga.hpp"
#include "shared/srgb.h"

namespace lichtraum {
namespace {

constexpr std::int64_t max_pixels = std::int64_t(1) << 26;

/// False, with a reason, for what is empty or too large.
bool set_size(TextureImage& image, std::int64_t width, std::int64_t height, std::string& reason) {
  if (width <= 0 || height <= 0 || width > max_pixels / height) {
    reason = width <= 0 || height <= 0
                 ? "the header gives no size"
                 : fmt::format("it has {} x {} pixels, and up to 2^26 can be read (8192 x 8192)", width, height);
    return false;
  }
  image.width = int(width);
  image.height = int(height);
  return true;
}

bool allocate(TextureImage& image, std::int64_t width, std::int64_t height, std::string& reason) {
  if (!set_size(image, width, height, reason)) return false;
  image.rgba.resize(std::size_t(width * height * 4));
  return true;
}

/// What a PNG's header says: the first chunk is IHDR (PNG 11.2.1), or the picture is refused.
ImageSize size_of_png(std::string_view bytes) {
  auto const number = [&](std::size_t first) {
    std::int64_t value = 0;
    for (std::size_t i = first; i < first + 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes[i]);
    return value;
  };
  return bytes.size() < 24 ? ImageSize() : ImageSize{number(16), number(20)};
}

struct JpegHeader {
  int width = 0, height = 0;
  int color_space = -1;  ///< a TJCS
};

/// Nothing where it is none.
std::optional<JpegHeader> jpeg_header(tjhandle decoder, std::string_view bytes) {
  JpegHeader header;
  int subsampling = -1;
  int const error = tjDecompressHeader3(decoder, reinterpret_cast<unsigned char const*>(bytes.data()), bytes.size(),
                                        &header.width, &header.height, &subsampling, &header.color_space);
  // Subsampling that TurboJPEG has no name for is an error that says all the rest, and is decoded as any other.
  bool const is_known = error == 0 || (subsampling < 0 && header.color_space >= 0);
  if (!is_known || header.width <= 0 || header.height <= 0) return std::nullopt;
  return header;
}

ImageSize size_of_jpeg(std::string_view bytes) {
  std::unique_ptr<void, int (*)(tjhandle)> const decoder(tjInitDecompress(), tjDestroy);
  auto const header = jpeg_header(decoder.get(), bytes);
  return header ? ImageSize{header->width, header->height} : ImageSize();
}

ImageSize size_of_webp(std::string_view bytes) {
  int width = 0, height = 0;
  bool const is_known = WebPGetInfo(reinterpret_cast<std::uint8_t const*>(bytes.data()), bytes.size(), &width, &height);
  return is_known ? ImageSize{width, height} : ImageSize();
}

bool is_png(std::string_view bytes) { return bytes.substr(0, 4) == "\x89PNG"; }
bool is_jpeg(std::string_view bytes) { return bytes.substr(0, 3) == "\xFF\xD8\xFF"; }
bool is_webp(std::string_view bytes) {
  return bytes.substr(0, 4) == "RIFF" && bytes.size() >= 12 && bytes.substr(8, 4) == "WEBP";
}

/// With the size that is foretold, as no other is accepted.
bool decode_png_of_size(std::string_view bytes, TextureImage& image, std::string& reason) {
  auto const [width, height] = size_of_png(bytes);
  return set_size(image, width, height, reason) && decode_png(bytes, image, reason);
}

/// Cyan, magenta, yellow and black as Adobe's programs write them, 255 for no ink, to what light they leave. No profile
/// is looked at.
void inks_to_rgba(std::vector<std::uint8_t>& pixels) {
  for (std::size_t i = 0; i < pixels.size(); i += 4) {
    unsigned const black = pixels[i + 3];
    for (std::size_t c = 0; c < 3; ++c) pixels[i + c] = std::uint8_t((pixels[i + c] * black + 127) / 255);
    pixels[i + 3] = 255;
  }
}

bool decode_jpeg(std::string_view bytes, TextureImage& image, std::string& reason) {
  std::unique_ptr<void, int (*)(tjhandle)> const decoder(tjInitDecompress(), tjDestroy);
  auto const* data = reinterpret_cast<unsigned char const*>(bytes.data());
  auto const header = jpeg_header(decoder.get(), bytes);
  if (!header) {
    reason = tjGetErrorStr2(decoder.get());
    return false;
  }
  auto const [width, height, color_space] = *header;
  if (!allocate(image, width, height, reason)) return false;
  bool const has_inks = color_space == TJCS_CMYK || color_space == TJCS_YCCK;
  // A progressive picture can go over all its pixels once for every 12 bytes of its file: 500 times are allowed.
  int const result = tjDecompress2(decoder.get(), data, bytes.size(), image.rgba.data(), width, 0, height,
                                   has_inks ? TJPF_CMYK : TJPF_RGBA, TJFLAG_LIMITSCANS);
  if (result != 0 && tjGetErrorCode(decoder.get()) != TJERR_WARNING) {  // cut off: what is there is shown
    reason = tjGetErrorStr2(decoder.get());
    return false;
  }
  if (has_inks) inks_to_rgba(image.rgba);
  return true;
}

bool decode_webp(std::string_view bytes, TextureImage& image, std::string& reason) {
  auto const* data = reinterpret_cast<std::uint8_t const*>(bytes.data());
  int width = 0, height = 0;
  if (!WebPGetInfo(data, bytes.size(), &width, &height)) {
    reason = "the WebP header is damaged";
    return false;
  }
  if (!allocate(image, width, height, reason)) return false;
  if (WebPDecodeRGBAInto(data, bytes.size(), image.rgba.data(), image.rgba.size(), 4 * width)) return true;
  reason = "the WebP data is damaged";
  return false;
}

/// Where the light of one byte of sRGB ends, and that of the next begins.
std::array<double, 255> limits_of_srgb() {
  std::array<double, 255> limits;
  for (std::size_t i = 0; i < limits.size(); ++i) limits[i] = linear_from_srgb((double(i) + 0.5) / 255);
  return limits;
}

/// Half as wide and high: the mean of four pixels, of colours that of their light. The last row or column of an odd
/// size counts twice.
TextureImage halved(TextureImage const& image, TexelContent content) {
  auto const limits = limits_of_srgb();
  TextureImage half;
  half.name = image.name;
  ImageSize const size = ImageSize{image.width, image.height}.halved();
  half.width = int(size.width);
  half.height = int(size.height);
  half.rgba.resize(std::size_t(half.width) * std::size_t(half.height) * 4);
  auto const at = [&](int x, int y, int channel) {
    auto const column = std::size_t(std::min(x, image.width - 1));
    auto const row = std::size_t(std::min(y, image.height - 1));
    return image.rgba[4 * (row * std::size_t(image.width) + column) + std::size_t(channel)];
  };
  std::uint8_t* out = half.rgba.data();
  for (int y = 0; y < half.height; ++y) {
    for (int x = 0; x < half.width; ++x) {
      for (int c = 0; c < 4; ++c) {
        std::uint8_t const four[] = {at(2 * x, 2 * y, c), at(2 * x + 1, 2 * y, c), at(2 * x, 2 * y + 1, c),
                                     at(2 * x + 1, 2 * y + 1, c)};
        if (content == TexelContent::color && c < 3) {
          double light = 0;
          for (std::uint8_t const byte : four) light += double(device::linear_from_srgb_table[byte]) / 4;
          *out++ = std::uint8_t(std::ranges::upper_bound(limits, light) - limits.begin());
        } else {
          *out++ = std::uint8_t((four[0] + four[1] + four[2] + four[3] + 2) / 4);
        }
      }
    }
  }
  return half;
}

}  // namespace

std::optional<TextureImage> decode_image(std::string_view bytes, int max_size, TexelContent content,
                                         std::string& reason) {
  TextureImage image;
  bool is_decoded = false;
  if (is_png(bytes)) {
    is_decoded = decode_png_of_size(bytes, image, reason);
  } else if (is_jpeg(bytes)) {
    is_decoded = decode_jpeg(bytes, image, reason);
  } else if (is_webp(bytes)) {
    is_decoded = decode_webp(bytes, image, reason);
  } else if (is_bmp(bytes)) {
    auto const [width, height] = size_of_bmp(bytes);
    is_decoded = set_size(image, width, height, reason) && decode_bmp(bytes, image, reason);
  } else if (is_tga(bytes)) {
    auto const [width, height] = size_of_tga(bytes);
    is_decoded = set_size(image, width, height, reason) && decode_tga(bytes, image, reason);
  } else if (bytes.substr(0, 7) == "\xABKTX 20" || bytes.substr(0, 7) == "\xABKTX 11") {
    reason = "KTX pictures cannot be decoded";
  } else {
    reason = "it is not a PNG, JPEG, WebP, BMP or TGA file";
  }
  if (!is_decoded) return std::nullopt;
  while (std::max(image.width, image.height) > std::max(max_size, 1)) image = halved(image, content);
  return image;
}

ImageSize decoded_size(std::string_view bytes, int max_size) {
  ImageSize size = is_png(bytes)    ? size_of_png(bytes)
                   : is_jpeg(bytes) ? size_of_jpeg(bytes)
                   : is_webp(bytes) ? size_of_webp(bytes)
                   : is_bmp(bytes)  ? size_of_bmp(bytes)
                   : is_tga(bytes)  ? size_of_tga(bytes)
                                    : ImageSize();
  if (size.width <= 0 || size.height <= 0 || size.width > max_pixels / size.height) return {};
  while (size.longer_side() > std::max(max_size, 1)) size = size.halved();
  return size;
}

}  // namespace lichtraum
