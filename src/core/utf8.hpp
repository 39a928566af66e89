#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace lichtraum {

struct CodePoint {
  std::uint32_t value = 0;
  std::size_t length = 0;  ///< in bytes; 0: not UTF-8
};

/// The first character of `text`, which must not be empty. Well-formed UTF-8 only (Unicode 15, table 3-7): no overlong
/// forms, no surrogates, nothing above 10FFFF.
CodePoint decode_utf8(std::string_view text);

/// Whether all of `text` is well-formed UTF-8.
bool is_utf8(std::string_view text);

}  // namespace lichtraum
