#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "core/parse_number.hpp"
#include "core/printable.hpp"
#include "io/image/environment_decoders.hpp"

namespace lichtraum {
namespace {

using Rgbe = std::array<std::uint8_t, 4>;

class HdrReader {
 public:
  explicit HdrReader(EnvironmentFile const& file) : file_(file) {}

  std::string_view line() {
    std::size_t const end = file_.bytes.find('\n', at_);
    if (end == std::string_view::npos) file_.fail_cut_short(file_.bytes.size());
    std::string_view line = file_.bytes.substr(at_, end - at_);
    at_ = end + 1;
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
  }
  std::uint8_t byte() {
    if (at_ == file_.bytes.size()) file_.fail_cut_short(at_);
    return std::uint8_t(file_.bytes[at_++]);
  }
  Rgbe pixel() {
    Rgbe pixel;
    for (std::uint8_t& value : pixel) value = byte();
    return pixel;
  }
  [[noreturn]] void fail(std::string const& what) const { file_.fail(at_, what); }

 private:
  EnvironmentFile const& file_;
  std::size_t at_ = 0;
};

struct Header {
  double exposure = 1;  ///< what the values were multiplied by
  std::int64_t width = 0, height = 0;
  bool is_upside_down = false;
  bool is_mirrored = false;
};

/// Two axes, each with its sign and size: "-Y 1024 +X 2048".
void parse_resolution(HdrReader const& reader, std::string_view const whole_line, Header& header) {
  std::string_view line = whole_line;
  auto const refuse = [&] {
    reader.fail(fmt::format("the line before this must be a resolution like '-Y 1024 +X 2048', and is '{}'",
                            printable(whole_line.substr(0, 60))));
  };
  auto const take = [&](char axis, bool& is_negative) -> std::int64_t {
    if (line.size() < 4 || (line[0] != '+' && line[0] != '-') || line[1] != axis || line[2] != ' ') refuse();
    is_negative = line[0] == '-';
    line.remove_prefix(3);
    std::size_t const end = std::min(line.find(' '), line.size());
    ParsedNumber const number = parse_number(line.substr(0, end));
    if (number.problem != NumberProblem::none || !(std::abs(number.value) <= 1e9)) refuse();
    line.remove_prefix(std::min(end + 1, line.size()));
    return std::int64_t(number.value);
  };
  bool is_from_top = true, is_from_right = false;
  header.height = take('Y', is_from_top);
  header.width = take('X', is_from_right);
  if (!line.empty()) refuse();
  header.is_upside_down = !is_from_top;
  header.is_mirrored = is_from_right;
}

Header read_header(HdrReader& reader) {
  Header header;
  for (reader.line();;) {  // the first says that it is such a file
    std::string_view const line = reader.line();
    if (line.empty()) break;
    if (line.starts_with("FORMAT=") && line != "FORMAT=32-bit_rle_rgbe") {
      reader.fail(fmt::format("the line before this says '{}', and of Radiance's formats only 32-bit_rle_rgbe is read",
                              printable(line.substr(0, 60))));
    }
    if (line.starts_with("EXPOSURE=")) {  // several count as their product
      std::string_view const text = line.substr(std::min(line.size(), line.find_first_not_of(" \t", 9)));
      ParsedNumber const number = parse_number(text.substr(0, text.find_last_not_of(" \t") + 1));
      if (!number.has_value() || !(number.value > 0))
        reader.fail("the exposure in the line before this is not above 0");
      header.exposure *= number.value;
    }
  }
  parse_resolution(reader, reader.line(), header);
  return header;
}

/// A row of run lengths a component; its first four bytes are read.
void read_components(HdrReader& reader, std::span<Rgbe> row) {
  for (std::size_t c = 0; c < 4; ++c) {
    for (std::size_t i = 0; i < row.size();) {
      std::size_t const code = reader.byte();
      std::size_t const count = code > 128 ? code - 128 : code;
      if (count == 0 || count > row.size() - i) reader.fail("a run of pixels ends beyond its row: the file is damaged");
      if (code > 128) {
        std::uint8_t const value = reader.byte();
        for (std::size_t k = 0; k < count; ++k) row[i++][c] = value;
      } else {
        for (std::size_t k = 0; k < count; ++k) row[i++][c] = reader.byte();
      }
    }
  }
}

/// A row pixel by pixel, where 1, 1, 1, n says: the last one n times again. Such counts one after the other are a
/// number of base 256, its lowest digit first.
void read_pixels(HdrReader& reader, Rgbe pixel, std::span<Rgbe> row) {
  unsigned shift = 0;
  for (std::size_t i = 0;;) {
    if (pixel[0] == 1 && pixel[1] == 1 && pixel[2] == 1) {
      std::size_t const count = shift < 32 ? std::size_t(pixel[3]) << shift : row.size() + 1;
      if (i == 0 || count > row.size() - i) reader.fail("a run of pixels ends beyond its row: the file is damaged");
      for (std::size_t k = 0; k < count; ++k, ++i) row[i] = row[i - 1];
      shift += 8;
    } else {
      row[i++] = pixel;
      shift = 0;
    }
    if (i == row.size()) return;
    pixel = reader.pixel();
  }
}

void read_row(HdrReader& reader, std::span<Rgbe> row) {
  Rgbe const first = reader.pixel();
  bool const has_components = row.size() >= 8 && row.size() < 32768 && first[0] == 2 && first[1] == 2 && first[2] < 128;
  if (!has_components) return read_pixels(reader, first, row);
  if (256 * std::size_t(first[2]) + first[3] != row.size()) reader.fail("a row has another length than the others");
  read_components(reader, row);
}

}  // namespace

EnvironmentMap decode_hdr(EnvironmentFile const& file) {
  HdrReader reader(file);
  Header const header = read_header(reader);
  EnvironmentMap map = file.sized(header.width, header.height);
  auto const width = std::size_t(map.width), height = std::size_t(map.height);
  std::vector<Rgbe> row(width);
  for (std::size_t y = 0; y < height; ++y) {
    read_row(reader, row);
    // Memory is taken row by row: a short file may say that it is a large one.
    map.radiance.resize(3 * width * (y + 1));
    float* out = &map.radiance[3 * width * y];
    for (std::size_t x = 0; x < width; ++x) {
      Rgbe const& pixel = row[header.is_mirrored ? width - 1 - x : x];
      // As most readers, Blender's and three.js' among them, have it; Radiance itself adds half a step.
      double const unit = pixel[3] == 0 ? 0 : std::ldexp(1.0, int(pixel[3]) - 136) / header.exposure;
      for (std::size_t c = 0; c < 3; ++c) *out++ = float(pixel[c] * unit);
    }
  }
  if (header.is_upside_down) {
    for (std::size_t y = 0; y < height / 2; ++y) {
      auto const begin = map.radiance.begin(), upper = begin + std::ptrdiff_t(3 * width * y);
      std::swap_ranges(upper, upper + std::ptrdiff_t(3 * width), begin + std::ptrdiff_t(3 * width * (height - 1 - y)));
    }
  }
  return map;
}

}  // namespace lichtraum
