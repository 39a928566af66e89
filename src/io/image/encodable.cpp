#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "io/image/encoders.hpp"

namespace lichtraum {
namespace {

std::size_t pixel_count(Resolution const& size) { return std::size_t(size.width) * std::size_t(size.height); }

void check_size(Resolution const& size, ImageFormat const& format) {
  int const side = std::max(size.width, size.height);
  if (pixel_count(size) > 0 && side <= format.max_side) return;
  throw std::invalid_argument(fmt::format("a {} cannot have {}x{} pixels", format.name, size.width, size.height));
}

}  // namespace

void check_encodable(Image const& image, ValueEncoding const& encoding, std::string_view format_name) {
  ImageFormat const& format = image_format_named(format_name);
  check_size(image.size(), format);
  std::size_t const pixels = pixel_count(image.size());
  if (image.data().size() != 3 * pixels || (!image.alpha().empty() && image.alpha().size() != pixels)) {
    throw std::invalid_argument("an image needs three numbers a pixel, and an alpha for each or none");
  }
  if ((encoding.bits != 8 && encoding.bits != 16) || encoding.bits > format.max_bits) {
    throw std::invalid_argument(fmt::format("a {} cannot have {} bits per channel", format.name, encoding.bits));
  }
  if (encoding.jpeg_quality < 1 || encoding.jpeg_quality > 100) {
    throw std::invalid_argument(fmt::format("the quality of a JPEG is 1 to 100, not {}", encoding.jpeg_quality));
  }
}

void check_encodable(Film const& film, std::string_view format_name) {
  ImageFormat const& format = image_format_named(format_name);
  check_size(film.size(), format);
  auto const planes = film.planes().list();
  if (planes.empty() || planes.size() > format.max_planes) {
    throw std::invalid_argument(fmt::format("a {} cannot have {} planes", format.name, planes.size()));
  }
  for (FilmPlane const plane : planes) {
    if (info_of(plane).rule != PlaneRule::center || film.samples().first == 0) continue;
    throw std::invalid_argument(fmt::format(
        "the plane '{}' is of a picture's first sample: merge this film into the one before it", info_of(plane).name));
  }
}

}  // namespace lichtraum
