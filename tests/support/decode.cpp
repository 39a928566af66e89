#include "support/decode.hpp"

#include <OpenEXR/ImfArray.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputFile.h>
#include <png.h>
#include <turbojpeg.h>

#include <cstring>
#include <sstream>
#include <stdexcept>
#include <string>

namespace {

[[noreturn]] void fail(std::string const& why) { throw std::runtime_error("decode: " + why); }

std::size_t value_count(DecodedImage const& image) {
  return 3 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
}

struct NetpbmHeader {
  std::string magic;
  int width = 0;
  int height = 0;
  double last = 0;  // PPM: the largest value; PFM: the scale
  std::string_view body;
};

NetpbmHeader read_netpbm_header(std::string_view bytes) {
  std::istringstream in{std::string(bytes.substr(0, 100))};
  NetpbmHeader header;
  in >> header.magic >> header.width >> header.height >> header.last;
  if (!in || header.width < 1 || header.height < 1) fail("a broken header");
  header.body = bytes.substr(static_cast<std::size_t>(in.tellg()) + 1);
  return header;
}

DecodedImage decode_ppm(std::string_view bytes) {
  NetpbmHeader const header = read_netpbm_header(bytes);
  DecodedImage image{header.width, header.height, static_cast<int>(header.last), {}};
  if (image.max != 255 && image.max != 65535) fail("an odd largest value");
  if (header.magic == "P3") {
    std::istringstream in{std::string(header.body)};
    for (int value = 0; in >> value;) image.values.push_back(static_cast<float>(value));
    if (!in.eof()) fail("no number");
  } else {
    auto const* byte = reinterpret_cast<unsigned char const*>(header.body.data());
    std::size_t const width = image.max == 255 ? 1 : 2;
    if (header.body.size() != value_count(image) * width) fail("a wrong number of bytes");
    for (std::size_t i = 0; i < value_count(image); ++i) {
      image.values.push_back(static_cast<float>(width == 1 ? byte[i] : byte[2 * i] * 256 + byte[2 * i + 1]));
    }
  }
  if (image.values.size() != value_count(image)) fail("a wrong number of values");
  return image;
}

DecodedImage decode_pfm(std::string_view bytes) {
  NetpbmHeader const header = read_netpbm_header(bytes);
  if (header.last != -1) fail("not little endian");
  DecodedImage image{header.width, header.height, 0, {}};
  image.values.resize(value_count(image));
  if (header.body.size() != 4 * image.values.size()) fail("a wrong number of bytes");
  std::size_t const row = 12 * static_cast<std::size_t>(image.width);
  for (int y = 0; y < image.height; ++y) {
    std::memcpy(reinterpret_cast<char*>(image.values.data()) + row * static_cast<std::size_t>(image.height - 1 - y),
                header.body.data() + row * static_cast<std::size_t>(y), row);
  }
  return image;
}

DecodedImage decode_png(std::string_view bytes) {
  struct Reader {
    std::string_view rest;
    png_structp png = png_create_read_struct(
        PNG_LIBPNG_VER_STRING, nullptr, [](png_structp, char const* message) { fail(message); },
        [](png_structp, char const* message) { fail(message); });
    png_infop info = png_create_info_struct(png);
    ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
  } reader{bytes};
  png_set_read_fn(reader.png, &reader.rest, [](png_structp png, png_bytep out, std::size_t size) {
    auto& rest = *static_cast<std::string_view*>(png_get_io_ptr(png));
    if (size > rest.size()) fail("cut off");
    std::memcpy(out, rest.data(), size);
    rest.remove_prefix(size);
  });
  png_read_png(reader.png, reader.info, 0, nullptr);
  if (png_get_color_type(reader.png, reader.info) != PNG_COLOR_TYPE_RGB) fail("not RGB");
  DecodedImage image{static_cast<int>(png_get_image_width(reader.png, reader.info)),
                     static_cast<int>(png_get_image_height(reader.png, reader.info)),
                     (1 << png_get_bit_depth(reader.png, reader.info)) - 1,
                     {}};
  png_bytepp const rows = png_get_rows(reader.png, reader.info);
  for (int y = 0; y < image.height; ++y) {
    for (int i = 0; i < 3 * image.width; ++i) {
      image.values.push_back(
          static_cast<float>(image.max == 255 ? rows[y][i] : rows[y][2 * i] * 256 + rows[y][2 * i + 1]));
    }
  }
  if (!reader.rest.empty()) fail("bytes after the end");
  return image;
}

DecodedImage decode_jpeg(std::string_view bytes) {
  tjhandle const handle = tjInitDecompress();
  auto const* const data = reinterpret_cast<unsigned char const*>(bytes.data());
  DecodedImage image;
  image.max = 255;
  int subsampling = 0;
  int color_space = 0;
  if (tjDecompressHeader3(handle, data, bytes.size(), &image.width, &image.height, &subsampling, &color_space) != 0) {
    fail(tjGetErrorStr2(handle));
  }
  std::vector<unsigned char> pixels(value_count(image));
  if (tjDecompress2(handle, data, bytes.size(), pixels.data(), image.width, 0, image.height, TJPF_RGB, 0) != 0) {
    fail(tjGetErrorStr2(handle));
  }
  image.values.assign(pixels.begin(), pixels.end());
  tjDestroy(handle);
  return image;
}

DecodedImage decode_exr(std::string_view bytes) {
  struct Stream final : Imf::IStream {
    explicit Stream(std::string_view text) : IStream("test"), bytes(text) {}
    bool read(char out[], int size) override {
      if (position + static_cast<std::size_t>(size) > bytes.size()) fail("cut off");
      std::memcpy(out, bytes.data() + position, static_cast<std::size_t>(size));
      position += static_cast<std::size_t>(size);
      return position < bytes.size();
    }
    std::uint64_t tellg() override { return position; }
    void seekg(std::uint64_t to) override { position = to; }
    std::string_view bytes;
    std::size_t position = 0;
  } stream(bytes);
  Imf::InputFile file(stream);
  auto const window = file.header().dataWindow();
  if (window.min.x != 0 || window.min.y != 0) fail("an odd window");
  if (window != file.header().displayWindow()) fail("windows that differ");
  DecodedImage image{window.max.x + 1, window.max.y + 1, 0, {}};
  image.values.resize(value_count(image));
  Imf::FrameBuffer frame;
  char const* const names[] = {"R", "G", "B"};
  for (int c = 0; c < 3; ++c) {
    if (!file.header().channels().findChannel(names[c])) fail("a channel is missing");
    frame.insert(names[c], Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(image.values.data() + c), 12,
                                      12 * static_cast<std::size_t>(image.width)));
  }
  file.setFrameBuffer(frame);
  file.readPixels(0, image.height - 1);
  return image;
}

}  // namespace

DecodedImage decode(std::string_view bytes) {
  auto const starts_with = [&](std::string_view magic) { return bytes.substr(0, magic.size()) == magic; };
  if (starts_with("P3") || starts_with("P6")) return decode_ppm(bytes);
  if (starts_with("PF")) return decode_pfm(bytes);
  if (starts_with("\x89PNG")) return decode_png(bytes);
  if (starts_with("\xff\xd8\xff")) return decode_jpeg(bytes);
  if (starts_with("\x76\x2f\x31\x01")) return decode_exr(bytes);
  fail("no known picture");
}
