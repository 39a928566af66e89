#include "core/printable.hpp"

#include <cstdint>

namespace lichtraum {
namespace {

struct CodePoint {
  std::uint32_t value = 0;
  std::size_t length = 0;  // in bytes; 0: not UTF-8
};

// Unicode 15, table 3-7: no overlong forms, no surrogates, nothing above 10FFFF.
CodePoint decode(std::string_view text) {
  auto const byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
  std::uint32_t const lead = byte(0);
  if (lead < 0x80) return {lead, 1};
  std::size_t const length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || text.size() < length) return {};
  std::uint32_t value = lead & (0x7Fu >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return {};
    value = value << 6 | (byte(i) & 0x3Fu);
  }
  constexpr std::uint32_t smallest[] = {0, 0, 0x80, 0x800, 0x10000};
  if (value < smallest[length] || value > 0x10FFFF || (value >= 0xD800 && value <= 0xDFFF)) return {};
  return {value, length};
}

bool is_harmless(std::uint32_t c) {
  if (c == '\t') return true;
  bool const is_control = c < 0x20 || (c >= 0x7F && c < 0xA0);
  bool const is_line_or_direction_mark = (c >= 0x200B && c <= 0x200F) || (c >= 0x2028 && c <= 0x202E) ||
                                         (c >= 0x2066 && c <= 0x2069) || c == 0xFEFF;
  return !is_control && !is_line_or_direction_mark;
}

}  // namespace

std::vector<PrintableCharacter> printable_characters(std::string_view text) {
  std::vector<PrintableCharacter> result;
  for (std::size_t at = 0; at < text.size();) {
    CodePoint const c = decode(text.substr(at));
    bool const shown = c.length > 0 && is_harmless(c.value);
    result.push_back({shown ? text.substr(at, c.length) : std::string_view("?"), at});
    at += c.length > 0 ? c.length : 1;
  }
  return result;
}

std::string printable(std::string_view text) {
  std::string result;
  for (auto const& character : printable_characters(text)) result += character.text;
  return result;
}

}  // namespace lichtraum
