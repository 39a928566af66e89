#include <fmt/format.h>

#include <bit>
#include <cstring>

#include "io/image/encoders.hpp"

namespace lichtraum {

static_assert(std::endian::native == std::endian::little, "PFM is written as the floats lie in memory");

std::string encode_pfm(Image const& image, ImageEncoding const&) {
  // A negative scale says little endian.
  std::string bytes = fmt::format("PF\n{} {}\n-1.0\n", image.width(), image.height());
  std::size_t const header = bytes.size();
  std::size_t const row = 3 * sizeof(float) * std::size_t(image.width());
  bytes.resize(header + row * std::size_t(image.height()));
  for (int y = 0; y < image.height(); ++y) {
    // The first row of the file is the lowest.
    std::memcpy(bytes.data() + header + row * std::size_t(image.height() - 1 - y), image.pixel(0, y), row);
  }
  return bytes;
}

}  // namespace lichtraum
