#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace lichtraum {

/// One character of a text as it can be shown: a UTF-8 sequence, or '?' for an invalid byte, and for controls and
/// marks of direction, which could do harm to a terminal or hide what a line says. A tab stays.
struct PrintableCharacter {
  std::string_view text;
  std::size_t first_byte;  ///< in the original
};

std::vector<PrintableCharacter> printable_characters(std::string_view text);

std::string printable(std::string_view text);

}  // namespace lichtraum
