#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "core/parse_number.hpp"
#include "io/image/environment_decoders.hpp"

namespace lichtraum {
namespace {

float swapped(float value) {
  auto bytes = std::bit_cast<std::array<char, 4>>(value);
  std::ranges::reverse(bytes);
  return std::bit_cast<float>(bytes);
}

/// The header's next word. After the last one comes a single white space.
std::string_view next_word(EnvironmentFile const& file, std::size_t& at) {
  constexpr std::string_view white_space = " \t\r\n";
  std::size_t const begin = file.bytes.find_first_not_of(white_space, at);
  std::size_t const end = file.bytes.find_first_of(white_space, begin);
  if (end == std::string_view::npos) file.fail_cut_short(file.bytes.size());
  at = end + 1;
  return file.bytes.substr(begin, end - begin);
}

double next_number(EnvironmentFile const& file, std::size_t& at, char const* what) {
  std::string_view const word = next_word(file, at);
  ParsedNumber const number = parse_number(word.substr(0, 40));
  if (number.problem != NumberProblem::none) {
    file.fail(at - 1 - word.size(), fmt::format("the header must have the {} here, a number", what));
  }
  return number.value;
}

std::int64_t next_size(EnvironmentFile const& file, std::size_t& at, char const* what) {
  double const size = next_number(file, at, what);
  if (!(size >= 0 && size <= 1e9)) file.fail(fmt::format("a {} of {} pixels is not possible", what, size));
  return std::int64_t(size);
}

}  // namespace

EnvironmentMap decode_pfm(EnvironmentFile const& file) {
  std::size_t at = 0;
  std::string_view const kind = next_word(file, at);
  if (kind != "PF" && kind != "Pf") file.fail("a PFM file begins with PF or Pf, and a line break");
  std::size_t const channels = kind == "PF" ? 3 : 1;
  std::int64_t const file_width = next_size(file, at, "width"), file_height = next_size(file, at, "height");
  // Its sign is the byte order. What its amount means is nowhere agreed upon.
  bool const is_little = next_number(file, at, "scale") < 0;
  EnvironmentMap map = file.sized(file_width, file_height);
  auto const width = std::size_t(map.width), height = std::size_t(map.height);
  if (file.bytes.size() - at < sizeof(float) * channels * width * height) file.fail_cut_short(file.bytes.size());
  map.radiance.resize(3 * width * height);
  bool const is_foreign = is_little != (std::endian::native == std::endian::little);
  for (std::size_t row = 0; row < height; ++row) {
    float* out = &map.radiance[3 * width * (height - 1 - row)];  // the first row of the file is the lowest
    for (std::size_t i = 0; i < 3 * width; ++i) {
      std::size_t const value = width * channels * row + (channels == 3 ? i : i / 3);
      std::memcpy(out + i, file.bytes.data() + at + sizeof(float) * value, sizeof(float));
      if (is_foreign) out[i] = swapped(out[i]);
    }
  }
  return map;
}

}  // namespace lichtraum
