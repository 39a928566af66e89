#pragma once

#include <memory>
#include <string>
#include <utility>

#include "lichtraum/image_io.hpp"

/// Functions of each format: the whole file as bytes, and the file by and by (see ImageFormat). The same picture gives
/// the same bytes, always: nothing here writes a time, a name or a version. Throws Error{internal} when the format's
/// library fails.

namespace lichtraum {

/// P6, or P3 with ppm_ascii; 8 or 16 bit (http://netpbm.sourceforge.net/doc/ppm.html).
std::string encode_ppm(Image const& image, ImageEncoding const& encoding);
/// RGB, or RGBA for an image with alpha, 8 or 16 bit.
std::string encode_png(Image const& image, ImageEncoding const& encoding);
/// YCbCr without chroma subsampling, 8 bit.
std::string encode_jpeg(Image const& image, ImageEncoding const& encoding);
/// Scan lines of all planes, a channel (see PlaneInfo) each of 32-bit floats or unsigned integers. Radiance is
/// premultiplied with alpha, as OpenEXR has it.
std::string encode_exr(Film const& film, ImageEncoding const& encoding);
/// PF, or Pf for a plane of one channel, 32-bit float, little endian (http://www.pauldebevec.com/Research/HDR/PFM/).
/// Numbers are exact up to 2^24.
std::string encode_pfm(Film const& film, ImageEncoding const& encoding);

std::unique_ptr<RowEncoder<Image>> begin_ppm(Resolution const& size, bool has_alpha, ImageEncoding const& encoding,
                                             ByteSink& sink);
std::unique_ptr<RowEncoder<Image>> begin_png(Resolution const& size, bool has_alpha, ImageEncoding const& encoding,
                                             ByteSink& sink);
std::unique_ptr<RowEncoder<Film>> begin_exr(Resolution const& size, PlaneSet const& planes,
                                            ImageEncoding const& encoding, ByteSink& sink);
std::unique_ptr<RowEncoder<Film>> begin_pfm(Resolution const& size, PlaneSet const& planes,
                                            ImageEncoding const& encoding, ByteSink& sink);

/// For the caller's mistakes. Throws std::invalid_argument for what a format cannot store: a picture of no pixels or
/// too many, or without all of their values; such bits, such a quality; such planes.
void check_encodable(Image const& image, ValueEncoding const& encoding, std::string_view format_name);
void check_encodable(Film const& film, std::string_view format_name);

/// A file in memory.
class MemorySink final : public ByteSink {
 public:
  explicit MemorySink(std::size_t expected_size = 0) { bytes_.reserve(expected_size); }
  void write(std::string_view bytes) override {
    if (position_ > bytes_.size()) bytes_.resize(position_);
    bytes_.replace(position_, bytes.size(), bytes);
    position_ += bytes.size();
  }
  void seek(std::uint64_t position) override { position_ = position; }
  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
  std::size_t position_ = 0;
};

std::string read_png_fingerprint(std::filesystem::path const& path);
std::string read_exr_fingerprint(std::filesystem::path const& path);

}  // namespace lichtraum
