#include "core/printable.hpp"

#include <cstdint>

#include "core/utf8.hpp"

namespace lichtraum {
namespace {

bool is_harmless(std::uint32_t c) {
  if (c == '\t') return true;
  bool const is_control = c < 0x20 || (c >= 0x7F && c < 0xA0);
  bool const is_line_or_direction_mark =
      (c >= 0x200B && c <= 0x200F) || (c >= 0x2028 && c <= 0x202E) || (c >= 0x2066 && c <= 0x2069) || c == 0xFEFF;
  return !is_control && !is_line_or_direction_mark;
}

}  // namespace

std::vector<PrintableCharacter> printable_characters(std::string_view text) {
  std::vector<PrintableCharacter> result;
  for (std::size_t at = 0; at < text.size();) {
    CodePoint const c = decode_utf8(text.substr(at));
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
