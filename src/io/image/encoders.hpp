#pragma once

#include <string>

#include "lichtraum/image_io.hpp"

/// One function a format: the whole file as bytes. The same picture gives the same bytes, always: nothing here writes
/// a time, a name or a version. Throws Error{internal} when the format's library fails.

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

std::string read_png_fingerprint(std::filesystem::path const& path);
std::string read_exr_fingerprint(std::filesystem::path const& path);

}  // namespace lichtraum
