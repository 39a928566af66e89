#include <png.h>
#include <zlib.h>

#include <algorithm>
#include <fstream>
#include <memory>
#include <string_view>
#include <vector>

#include "io/image/encoders.hpp"
#include "io/image/quantize.hpp"
#include "lichtraum/error.hpp"

namespace lichtraum {
namespace {

/// Compression, measured on one core with 1280 x 720 x 8 bit: a sphere on black / smooth / smooth with noise.
///   level 1, Z_RLE, Up           8 ms  113 kB /  21 ms 611 kB /  22 ms 1.67 MB   <- this
///   level 1, default, Up         9 ms  144 kB /  20 ms 555 kB /  41 ms 1.85 MB
///   level 1, Z_HUFFMAN_ONLY, Up 17 ms  374 kB /  18 ms 625 kB /  20 ms 1.67 MB
///   libpng's own choice         44 ms   83 kB / 147 ms 372 kB / 114 ms 1.60 MB
void choose_fast_compression(png_structp png) {
  png_set_compression_level(png, 1);
  png_set_compression_strategy(png, Z_RLE);
  png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_UP);
  png_set_compression_buffer_size(png, std::size_t(1) << 20);
}

[[noreturn]] void fail(png_structp, char const* message) {
  throw Error(ErrorKind::internal, std::string("libpng: ") + message);
}

struct Writer {
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, fail, [](png_structp, char const*) {});
  png_infop info = png_create_info_struct(png);

  explicit Writer(ByteSink& sink) {
    png_set_write_fn(
        png, &sink,
        [](png_structp p, png_bytep data, std::size_t size) {
          static_cast<ByteSink*>(png_get_io_ptr(p))->write({reinterpret_cast<char const*>(data), size});
        },
        [](png_structp) {});
  }
  Writer(Writer const&) = delete;
  Writer& operator=(Writer const&) = delete;
  ~Writer() { png_destroy_write_struct(&png, &info); }
};

constexpr char const* fingerprint_key = "lichtraum fingerprint";

void add_fingerprint(Writer& writer, std::string fingerprint) {
  if (fingerprint.empty()) return;
  std::string key = fingerprint_key;
  png_text text{};
  text.compression = PNG_TEXT_COMPRESSION_NONE;
  text.key = key.data();
  text.text = fingerprint.data();
  text.text_length = fingerprint.size();
  png_set_text(writer.png, writer.info, &text, 1);
}

struct PngReader {
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, fail, [](png_structp, char const*) {});
  png_infop info = png_create_info_struct(png);

  explicit PngReader(std::istream& file) {
    png_set_read_fn(png, &file, [](png_structp p, png_bytep data, std::size_t size) {
      auto& in = *static_cast<std::istream*>(png_get_io_ptr(p));
      if (!in.read(reinterpret_cast<char*>(data), std::streamsize(size))) fail(p, "the file is too short");
    });
  }
  PngReader(PngReader const&) = delete;
  PngReader& operator=(PngReader const&) = delete;
  ~PngReader() { png_destroy_read_struct(&png, &info, nullptr); }
};

/// Whether each chunk has the checksum that it was written with (PNG, 5.3), and the file ends with the one that ends a
/// PNG. Takes less time than decoding it. `chunks`: begin here.
bool is_undamaged(std::istream& chunks) {
  std::vector<unsigned char> bytes(std::size_t(1) << 16);
  auto const read = [&](std::size_t count) {
    return bool(chunks.read(reinterpret_cast<char*>(bytes.data()), std::streamsize(count)));
  };
  constexpr std::size_t length_size = 4, type_size = 4, checksum_size = 4;
  while (read(length_size + type_size)) {
    std::size_t left = png_get_uint_32(bytes.data());
    bool const is_last = std::string_view(reinterpret_cast<char*>(bytes.data()) + length_size, type_size) == "IEND";
    uLong checksum = crc32(0, bytes.data() + length_size, type_size);
    while (left > 0) {
      std::size_t const count = std::min(left, bytes.size());
      if (!read(count)) return false;
      checksum = crc32(checksum, bytes.data(), uInt(count));
      left -= count;
    }
    if (!read(checksum_size) || png_get_uint_32(bytes.data()) != checksum) return false;
    if (is_last) return chunks.peek() == std::istream::traits_type::eof();
  }
  return false;
}

class PngRows final : public RowEncoder<Image> {
 public:
  PngRows(Resolution const& size, bool has_alpha, ImageEncoding const& encoding, ByteSink& sink)
      : writer_(sink), bits_(encoding.bits), channels_(has_alpha ? 4 : 3) {
    choose_fast_compression(writer_.png);
    png_set_user_limits(writer_.png, 0x7fffffff, 0x7fffffff);  // libpng's own limit is a million
    png_set_IHDR(writer_.png, writer_.info, png_uint_32(size.width), png_uint_32(size.height), bits_,
                 has_alpha ? PNG_COLOR_TYPE_RGBA : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    add_fingerprint(writer_, encoding.fingerprint);
    png_write_info(writer_.png, writer_.info);
  }

  void add(Image const& rows) override {
    std::size_t const count = channels_ * std::size_t(rows.width());
    std::vector<float> with_alpha(channels_ == 4 ? count : 0);
    std::vector<unsigned char> row(count * (bits_ == 16 ? 2 : 1));
    for (int y = 0; y < rows.height(); ++y) {
      float const* values = rows.pixel(0, y);
      if (channels_ == 4) {
        float const* const alpha = rows.alpha().data() + std::size_t(y) * std::size_t(rows.width());
        for (std::size_t i = 0; i < count; ++i) with_alpha[i] = i % 4 == 3 ? alpha[i / 4] : values[i / 4 * 3 + i % 4];
        values = with_alpha.data();
      }
      bits_ == 16 ? quantize_16(values, count, row.data()) : quantize_8(values, count, row.data());
      png_write_row(writer_.png, row.data());
    }
  }

  void finish() override { png_write_end(writer_.png, writer_.info); }

 private:
  Writer writer_;
  int bits_;
  std::size_t channels_;
};

}  // namespace

std::string read_png_fingerprint(std::filesystem::path const& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return {};
  try {
    PngReader reader(file);
    png_set_user_limits(reader.png, 0x7fffffff, 0x7fffffff);
    png_read_info(reader.png, reader.info);
    png_textp texts = nullptr;
    int const count = png_get_text(reader.png, reader.info, &texts, nullptr);
    for (int i = 0; i < count; ++i) {
      if (texts[i].key != std::string_view(fingerprint_key)) continue;
      constexpr std::streamoff signature_size = 8;
      file.seekg(signature_size);
      return is_undamaged(file) ? std::string(texts[i].text, texts[i].text_length) : "";
    }
  } catch (Error const&) {  // no PNG
  }
  return {};
}

std::unique_ptr<RowEncoder<Image>> begin_png(Resolution const& size, bool has_alpha, ImageEncoding const& encoding,
                                             ByteSink& sink) {
  return std::make_unique<PngRows>(size, has_alpha, encoding, sink);
}

std::string encode_png(Image const& image, ImageEncoding const& encoding) {
  check_encodable(image, encoding, "png");
  MemorySink sink;
  PngRows rows(image.size(), !image.alpha().empty(), encoding, sink);
  rows.add(image);
  rows.finish();
  return sink.take();
}

}  // namespace lichtraum
