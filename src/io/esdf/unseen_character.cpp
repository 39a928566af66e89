#include "io/esdf/unseen_character.hpp"

#include <algorithm>

#include "core/utf8.hpp"

namespace lichtraum::esdf {
namespace {

// Not those that scripts need to join and direct their letters.
constexpr UnseenCharacter unseen_characters[] = {
    {{}, 0x00A0, "no-break space", true}, {{}, 0x00AD, "soft hyphen"},
    {{}, 0x2002, "en space", true},       {{}, 0x2003, "em space", true},
    {{}, 0x2007, "figure space", true},   {{}, 0x2009, "thin space", true},
    {{}, 0x200B, "zero-width space"},     {{}, 0x202F, "narrow no-break space", true},
    {{}, 0x2060, "word joiner"},          {{}, 0x3000, "ideographic space", true},
    {{}, 0xFEFF, "byte order mark"},
};

}  // namespace

std::optional<UnseenCharacter> find_unseen_character(Token token) {
  for (std::size_t i = 0; i < token.size();) {
    CodePoint const point = decode_utf8(token.substr(i));
    if (point.length == 0) return std::nullopt;
    auto const* const known = std::ranges::find(unseen_characters, point.value, &UnseenCharacter::value);
    if (known != std::end(unseen_characters)) {
      UnseenCharacter found = *known;
      found.at = token.substr(i, point.length);
      return found;
    }
    i += point.length;
  }
  return std::nullopt;
}

std::vector<Token> split_at_unseen_characters(std::span<Token const> tokens) {
  std::vector<Token> pieces;
  for (Token rest : tokens) {
    while (auto const unseen = find_unseen_character(rest)) {
      auto const before = static_cast<std::size_t>(unseen->at.data() - rest.data());
      if (before > 0) pieces.push_back(rest.substr(0, before));
      rest.remove_prefix(before + unseen->at.size());
    }
    if (!rest.empty()) pieces.push_back(rest);
  }
  return pieces;
}

}  // namespace lichtraum::esdf
