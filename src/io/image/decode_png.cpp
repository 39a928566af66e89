#include "io/image/decode_png.hpp"

#include <png.h>

#include <algorithm>
#include <stdexcept>

namespace lichtraum {
namespace {

[[noreturn]] void refuse_png(png_structp, char const* message) { throw std::runtime_error(message); }

/// Reads a picture in memory. Errors are exceptions rather than libpng's longjmp, which would skip destructors.
struct TexturePng {
  std::string_view rest;
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, refuse_png, [](png_structp, char const*) {});
  png_infop info = png_create_info_struct(png);

  explicit TexturePng(std::string_view bytes) : rest(bytes) {
    png_set_read_fn(png, &rest, [](png_structp p, png_bytep out, std::size_t size) {
      auto& unread = *static_cast<std::string_view*>(png_get_io_ptr(p));
      if (size > unread.size()) refuse_png(p, "the file is too short");
      std::copy_n(unread.begin(), size, out);
      unread.remove_prefix(size);
    });
  }
  TexturePng(TexturePng const&) = delete;
  TexturePng& operator=(TexturePng const&) = delete;
  ~TexturePng() { png_destroy_read_struct(&png, &info, nullptr); }
};

/// What hostile files could fill the memory with: rows of two copies and up to 16 bits, and chunks.
void limit_memory(png_structp png) {
  png_set_user_limits(png, 1'000'000, 1'000'000);
  png_set_chunk_malloc_max(png, 8'000'000);
  // All chunks but those with pixels, palette and transparency are skipped: texts and profiles unfold when read.
  png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_NEVER, nullptr, -1);
  png_set_benign_errors(png, 1);  // warnings, of which nobody hears
}

/// Eight bits each of red, green, blue and alpha, from every kind of PNG.
void ask_for_rgba(png_structp png) {
  png_set_expand(png);  // palettes, fewer than eight bits, and tRNS as alpha
  png_set_scale_16(png);
  png_set_gray_to_rgb(png);
  png_set_add_alpha(png, 0xFF, PNG_FILLER_AFTER);
}

}  // namespace

bool decode_png(std::string_view bytes, TextureImage& image, std::string& reason) {
  try {
    TexturePng file(bytes);
    limit_memory(file.png);
    png_read_info(file.png, file.info);
    auto const width = png_get_image_width(file.png, file.info), height = png_get_image_height(file.png, file.info);
    if (width != png_uint_32(image.width) || height != png_uint_32(image.height)) {
      reason = "the PNG's header is not its first chunk";
      return false;
    }
    ask_for_rgba(file.png);
    int const passes = png_set_interlace_handling(file.png);
    png_read_update_info(file.png, file.info);
    std::size_t const row_bytes = 4 * std::size_t(width);
    if (png_get_rowbytes(file.png, file.info) != row_bytes) throw std::runtime_error("libpng has another idea of RGBA");
    image.rgba.resize(row_bytes * height);
    for (int pass = 0; pass < passes; ++pass) {
      for (std::size_t y = 0; y < height; ++y) png_read_row(file.png, image.rgba.data() + y * row_bytes, nullptr);
    }
    return true;
  } catch (std::runtime_error const& error) {
    reason = error.what();
    return false;
  }
}

}  // namespace lichtraum
