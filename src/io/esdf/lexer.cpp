#include "io/esdf/lexer.hpp"

#include <array>
#include <cstdint>

namespace lichtraum::esdf {
namespace {

enum CharacterClass : std::uint8_t {
  plain = 0,
  control = 1,
  non_ascii = 2,
  brace = 4,
  equals = 8,
  blank = 16,
  comment = 32
};

constexpr std::array<std::uint8_t, 256> make_classes() {
  std::array<std::uint8_t, 256> classes{};
  for (std::size_t c = 0; c < 32; ++c) classes[c] = control;
  classes[127] = control;
  for (std::size_t c = 128; c < 256; ++c) classes[c] = non_ascii;
  for (char const c : {' ', '\t', '\v', '\f', '\r'}) classes[static_cast<std::size_t>(c)] = blank;
  classes['{'] = brace;
  classes['='] = equals;
  classes['#'] = comment;
  return classes;
}
constexpr auto classes = make_classes();

std::uint8_t class_of(char c) { return classes[static_cast<std::uint8_t>(c)]; }

}  // namespace

TokenTraits tokenize(std::string_view line, std::vector<Token>& tokens) {
  tokens.clear();
  unsigned seen = 0;
  char const* at = line.data();
  char const* const end = at + line.size();
  while (true) {
    while (at != end && class_of(*at) == blank) ++at;
    if (at == end || *at == '#') break;
    char const* const begin = at;
    for (; at != end; ++at) {
      unsigned const c = class_of(*at);
      if (c >= blank) break;
      seen |= c;
    }
    if (tokens.empty() && end - begin >= 2 && begin[0] == '/' && begin[1] == '/') return {};
    tokens.emplace_back(begin, static_cast<std::size_t>(at - begin));
  }
  return {(seen & control) != 0, (seen & non_ascii) != 0, (seen & brace) != 0, (seen & equals) != 0};
}

}  // namespace lichtraum::esdf
