#pragma once

#include <string_view>
#include <vector>

#include "io/text/lines.hpp"

namespace lichtraum::esdf {

/// What a line's tokens hold beside ordinary characters.
struct TokenTraits {
  bool has_control = false;    ///< a control character (blanks are none)
  bool has_non_ascii = false;  ///< a byte above 127
  bool has_brace = false;      ///< '{'
  bool has_equals = false;     ///< '='
};

/// The line's tokens, separated by blanks, up to a `#`. None for a line that starts with `//`.
TokenTraits tokenize(std::string_view line, std::vector<Token>& tokens);

}  // namespace lichtraum::esdf
