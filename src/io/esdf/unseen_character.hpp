#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "io/esdf/lexer.hpp"

namespace lichtraum::esdf {

/// A character that looks like a blank, or like nothing, and separates no words: texts from web pages and PDF documents
/// have them.
struct UnseenCharacter {
  Token at;
  std::uint32_t value = 0;  ///< its code point
  std::string_view name;    ///< Unicode's
  bool is_blank = false;    ///< takes room
};

/// The first one in `token`, which is UTF-8.
std::optional<UnseenCharacter> find_unseen_character(Token token);

/// What the tokens would be if such characters separated them.
std::vector<Token> split_at_unseen_characters(std::span<Token const> tokens);

}  // namespace lichtraum::esdf
