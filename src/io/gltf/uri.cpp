#include "io/gltf/uri.hpp"

#include <array>
#include <cstdint>

#include "core/ascii.hpp"
#include "core/percent.hpp"

namespace lichtraum::gltf {
namespace {

constexpr std::string_view data_scheme = "data:";

constexpr std::int8_t no_digit = -1;

constexpr std::array<std::int8_t, 256> make_base64_digits() {
  std::array<std::int8_t, 256> digits{};
  digits.fill(no_digit);
  for (int i = 0; i < 26; ++i) {
    digits[std::size_t('A' + i)] = std::int8_t(i);
    digits[std::size_t('a' + i)] = std::int8_t(26 + i);
  }
  for (int i = 0; i < 10; ++i) digits[std::size_t('0' + i)] = std::int8_t(52 + i);
  digits['+'] = digits['-'] = 62;
  digits['/'] = digits['_'] = 63;
  return digits;
}

std::optional<std::string> decode_base64(std::string_view text) {
  static constexpr auto digits = make_base64_digits();
  while (!text.empty() && text.back() == '=') text.remove_suffix(1);
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3 + 3);
  std::uint32_t bits = 0;
  int count = 0;
  for (char const c : text) {
    auto const digit = digits[static_cast<std::uint8_t>(c)];
    if (digit == no_digit) {
      if (c == ' ' || c == '\n' || c == '\r' || c == '\t') continue;
      return std::nullopt;
    }
    bits = bits << 6 | static_cast<std::uint32_t>(digit);
    count += 6;
    if (count >= 8) {
      count -= 8;
      bytes.push_back(static_cast<char>(bits >> count & 0xFF));
    }
  }
  if (count == 6) return std::nullopt;  // one digit alone is not a byte
  return bytes;
}

}  // namespace

bool is_data_uri(std::string_view uri) { return to_lower_ascii(uri.substr(0, data_scheme.size())) == data_scheme; }

std::optional<std::string> decode_data_uri(std::string_view uri) {
  std::size_t const comma = uri.find(',');
  if (!is_data_uri(uri) || comma == std::string_view::npos) return std::nullopt;
  std::string_view const head = uri.substr(0, comma);
  constexpr std::string_view base64 = ";base64";
  bool const is_base64 =
      head.size() >= base64.size() && to_lower_ascii(head.substr(head.size() - base64.size())) == base64;
  std::string_view const data = uri.substr(comma + 1);
  if (!is_base64) return decode_percent(data);
  return data.find('%') == std::string_view::npos ? decode_base64(data) : decode_base64(decode_percent(data));
}

bool has_scheme(std::string_view uri) {
  std::size_t const colon = uri.find(':');
  if (colon == std::string_view::npos || colon == 0) return false;
  for (char const c : to_lower_ascii(uri.substr(0, colon))) {
    bool const is_scheme_character =
        (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '+' || c == '-' || c == '.';
    if (!is_scheme_character) return false;
  }
  return true;
}

}  // namespace lichtraum::gltf
