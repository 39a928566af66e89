#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "io/drawn.hpp"
#include "io/text/diagnostics.hpp"

namespace lichtraum::ply {

enum class Encoding { ascii, little_endian, big_endian };
enum class Type { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

std::size_t size_of(Type type);

struct Property {
  std::string name;
  Type type = Type::float32;
  bool is_list = false;
  Type count_type = Type::uint8;  ///< of a list
};

struct Element {
  std::string name;
  std::uint64_t count = 0;
  std::vector<Property> properties;
};

/// What stands before the data (Turk 1994, "The PLY Polygon File Format").
struct Header {
  Encoding encoding = Encoding::ascii;
  std::vector<Element> elements;
  /// Of each "comment TextureFile", which many scanners' programs write; with slashes.
  std::vector<std::string> texture_files;
  std::size_t data_offset = 0;  ///< in bytes
  std::size_t data_line = 1;    ///< the line of the first data, counted from 1

  /// Faces where there are any, else edges, else vertices.
  Drawn draws() const;
};

/// Reads the header. Reports what is wrong in it as an error and returns false then.
bool read_header(std::string_view bytes, Header& header, Diagnostics& diagnostics);

}  // namespace lichtraum::ply
