#include <fmt/format.h>

#include <bit>
#include <cstring>

#include "io/image/encoders.hpp"

namespace lichtraum {

static_assert(std::endian::native == std::endian::little, "PFM is written as the floats lie in memory");

std::string encode_pfm(Film const& film, ImageEncoding const&) {
  FilmPlane const plane = film.planes().list().at(0);
  PlaneInfo const& info = info_of(plane);
  auto const numbers = info.is_number ? film.numbers(plane) : std::span<std::uint32_t const>();
  std::vector<float> const values =
      info.is_number ? std::vector<float>(numbers.begin(), numbers.end()) : film.values(plane);
  auto const [width, height] = film.size();
  // A negative scale says little endian.
  std::string bytes = fmt::format("{}\n{} {}\n-1.0\n", info.channels.size() == 3 ? "PF" : "Pf", width, height);
  std::size_t const header = bytes.size();
  std::size_t const row = info.channels.size() * std::size_t(width);
  bytes.resize(header + sizeof(float) * values.size());
  for (int y = 0; y < height; ++y) {
    // The first row of the file is the lowest.
    std::memcpy(bytes.data() + header + sizeof(float) * row * std::size_t(height - 1 - y),
                values.data() + row * std::size_t(y), sizeof(float) * row);
  }
  return bytes;
}

}  // namespace lichtraum
