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
  DecodedImage image{header.width, header.height, static_cast<int>(header.last), {}, {}};
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
  DecodedImage image{header.width, header.height, 0, {}, {}};
  std::size_t const repeats = header.magic == "Pf" ? 3 : 1;
  if (header.body.size() * repeats != 4 * value_count(image)) fail("a wrong number of bytes");
  std::size_t const row = 12 / repeats * static_cast<std::size_t>(image.width);
  for (int y = image.height - 1; y >= 0; --y) {
    for (std::size_t byte = 0; byte < row; byte += 4) {
      float value = 0;
      std::memcpy(&value, header.body.data() + row * static_cast<std::size_t>(y) + byte, 4);
      image.values.insert(image.values.end(), repeats, value);
    }
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
  int const channels = png_get_channels(reader.png, reader.info);
  if (channels < 3) fail("not RGB or RGBA");
  DecodedImage image{static_cast<int>(png_get_image_width(reader.png, reader.info)),
                     static_cast<int>(png_get_image_height(reader.png, reader.info)),
                     (1 << png_get_bit_depth(reader.png, reader.info)) - 1,
                     {},
                     {}};
  png_bytepp const rows = png_get_rows(reader.png, reader.info);
  for (int y = 0; y < image.height; ++y) {
    for (int i = 0; i < channels * image.width; ++i) {
      (i % channels == 3 ? image.alpha : image.values)
          .push_back(static_cast<float>(image.max == 255 ? rows[y][i] : rows[y][2 * i] * 256 + rows[y][2 * i + 1]));
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

struct ExrStream final : Imf::IStream {
  explicit ExrStream(std::string_view text) : IStream("test"), bytes(text) {}
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
};

/// Of a channel that must have that type.
template <class Value>
std::vector<Value> read_exr_channel(std::string_view bytes, char const* name, Imf::PixelType type) {
  ExrStream stream(bytes);
  Imf::InputFile file(stream);
  auto const window = file.header().dataWindow();
  if (window.min.x != 0 || window.min.y != 0) fail("an odd window");
  if (window != file.header().displayWindow()) fail("windows that differ");
  auto const* const channel = file.header().channels().findChannel(name);
  if (!channel || channel->type != type) fail(std::string("no such channel: ") + name);
  auto const width = static_cast<std::size_t>(window.max.x + 1);
  std::vector<Value> values(width * static_cast<std::size_t>(window.max.y + 1));
  Imf::FrameBuffer frame;
  frame.insert(name, Imf::Slice(type, reinterpret_cast<char*>(values.data()), 4, 4 * width));
  file.setFrameBuffer(frame);
  file.readPixels(0, window.max.y);
  return values;
}

DecodedImage decode_exr(std::string_view bytes) {
  ExrStream stream(bytes);
  auto const window = Imf::InputFile(stream).header().dataWindow();
  DecodedImage image{window.max.x + 1, window.max.y + 1, 0, {}, {}};
  image.values.resize(value_count(image));
  std::size_t c = 0;
  for (char const* const name : {"R", "G", "B"}) {
    auto const values = decode_exr_floats(bytes, name);
    for (std::size_t i = 0; i < values.size(); ++i) image.values[3 * i + c] = values[i];
    ++c;
  }
  return image;
}

}  // namespace

std::vector<float> decode_exr_floats(std::string_view bytes, char const* channel) {
  return read_exr_channel<float>(bytes, channel, Imf::FLOAT);
}

std::vector<std::uint32_t> decode_exr_numbers(std::string_view bytes, char const* channel) {
  return read_exr_channel<std::uint32_t>(bytes, channel, Imf::UINT);
}

DecodedImage decode(std::string_view bytes) {
  auto const starts_with = [&](std::string_view magic) { return bytes.substr(0, magic.size()) == magic; };
  if (starts_with("P3") || starts_with("P6")) return decode_ppm(bytes);
  if (starts_with("PF") || starts_with("Pf")) return decode_pfm(bytes);
  if (starts_with("\x89PNG")) return decode_png(bytes);
  if (starts_with("\xff\xd8\xff")) return decode_jpeg(bytes);
  if (starts_with("\x76\x2f\x31\x01")) return decode_exr(bytes);
  fail("no known picture");
}
