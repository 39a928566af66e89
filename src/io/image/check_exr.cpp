#include "io/image/check_exr.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <stdexcept>

#include "core/printable.hpp"

namespace lichtraum {
namespace {

constexpr std::int32_t magic_number = 20000630;
constexpr std::uint32_t several_parts = 0x1000;  // of the version's flags
constexpr double entry_bytes = 8;                // of the table of where blocks of pixels begin
/// Of a block's pixels, which OpenEXR takes some three times before it reads any. Room for 32,768 pixels a line in
/// blocks of 256 lines, which a file may hold in a few bytes if they are all the same.
constexpr double usual_block_bytes = 1 << 28;
constexpr double greatest_compression = 1100;  // of larger ones; zlib's is 1032
constexpr double value_bytes = 4;              // of a pixel in a channel, at most

/// "OpenEXR File Layout" (openexr.com), the section "Header". Numbers are little-endian.
class Reader {
 public:
  Reader(std::string_view bytes, std::uint64_t file_bytes) : bytes_(bytes), file_bytes_(file_bytes) {}

  std::string_view take(std::size_t count) {
    if (count > bytes_.size()) throw std::runtime_error("its header is cut short");
    std::string_view const taken = bytes_.substr(0, count);
    bytes_.remove_prefix(count);
    return taken;
  }
  std::string_view text() {
    std::string_view const taken = take(std::min(bytes_.find('\0'), bytes_.size()));
    take(1);
    return taken;
  }
  std::int32_t number() {
    std::int32_t value = 0;
    std::memcpy(&value, take(sizeof value).data(), sizeof value);
    return value;
  }
  bool is_at_end() const { return bytes_.empty(); }

  /// A length that is followed by as many bytes.
  std::string_view counted(std::string_view name) {
    std::int32_t const length = number();
    if (length < 0 || std::uint64_t(length) > file_bytes_) {
      throw std::runtime_error(fmt::format("its attribute '{}' claims to have {} bytes, and the file has {}",
                                           printable(name), std::uint32_t(length), file_bytes_));
    }
    return take(std::size_t(length));
  }

 private:
  std::string_view bytes_;
  std::uint64_t file_bytes_;
};

/// What decides into how many blocks a part's pixels are cut.
struct Part {
  double width = 0, height = 0;            // whole numbers, of which products may be large
  double tile_width = 0, tile_height = 0;  // 0: blocks are of whole lines
  double lines = 1;                        // in a block
  double said = 0;
  double channels = 0;

  double block_bytes() const {
    return value_bytes * channels * (tile_width > 0 ? tile_width * tile_height : width * lines);
  }
  double blocks() const {
    if (tile_width > 0) return std::ceil(width / tile_width) * std::ceil(height / tile_height);
    return std::ceil(height / lines);
  }
};

/// Lines in a block: none, RLE, ZIPS, ZIP, PIZ, PXR24, B44, B44A, DWAA, DWAB.
constexpr std::array<int, 10> lines_of_compression{1, 1, 1, 16, 32, 16, 32, 32, 32, 256};

void note(Part& part, std::string_view name, std::string_view value) {
  Reader reader(value, value.size());
  if (name == "dataWindow") {
    std::int64_t const left = reader.number(), top = reader.number();
    part.width = double(reader.number() - left + 1);
    part.height = double(reader.number() - top + 1);
  } else if (name == "tiles") {
    part.tile_width = std::uint32_t(reader.number());
    part.tile_height = std::uint32_t(reader.number());
  } else if (name == "compression") {
    auto const kind = std::size_t(static_cast<unsigned char>(reader.take(1)[0]));
    if (kind < lines_of_compression.size()) part.lines = lines_of_compression[kind];
  } else if (name == "channels") {
    while (!reader.text().empty()) {
      reader.take(16);  // the values' type, whether they are linear, and the distances of samples
      ++part.channels;
    }
  } else if (name == "chunkCount") {
    part.said = reader.number();
  }
}

/// False for the empty header that ends those of several parts.
bool check_part(Reader& reader, std::uint64_t file_bytes) {
  Part part;
  bool is_empty = true;
  for (std::string_view name = reader.text(); !name.empty(); name = reader.text()) {
    std::string_view const type = reader.text();
    std::string_view const value = reader.counted(name);
    if (type == "stringvector") {
      for (Reader strings(value, value.size()); !strings.is_at_end();) strings.counted(name);
    }
    note(part, name, value);
    is_empty = false;
  }
  if (is_empty) return false;
  bool const is_tiled = part.tile_width > 0 && part.tile_height > 0;
  if (part.width <= 0 || part.height <= 0 || (part.tile_width > 0) != is_tiled) return true;  // OpenEXR refuses them
  double const blocks = std::max(part.blocks(), part.said);
  if (entry_bytes * blocks > double(file_bytes)) {
    throw std::runtime_error(
        fmt::format("its header tells of {:.0f} x {:.0f} pixels in {:.0f} blocks, and the file has {} bytes",
                    part.width, part.height, blocks, file_bytes));
  }
  if (part.block_bytes() > std::max(usual_block_bytes, greatest_compression * double(file_bytes))) {
    throw std::runtime_error(fmt::format("its header tells of blocks of pixels of {:.0f} MB, and the file has {} bytes",
                                         part.block_bytes() / 1e6, file_bytes));
  }
  return true;
}

}  // namespace

void check_exr_header(std::string_view beginning, std::uint64_t file_bytes) {
  Reader reader(beginning, file_bytes);
  if (reader.number() != magic_number) throw std::runtime_error("it does not begin as OpenEXR files do");
  bool const has_parts = (std::uint32_t(reader.number()) & several_parts) != 0;
  while (check_part(reader, file_bytes) && has_parts) {
  }
}

}  // namespace lichtraum
