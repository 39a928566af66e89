#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace lichtraum::esdf {

using Token = std::string_view;  ///< always a part of its line, so that its column can be told

struct Line {
  std::string_view text;   ///< without its line break
  std::size_t number = 0;  ///< from 1
};

/// Removes what separates files and not statements: a byte order mark at the start; line breaks of old Macs (a CR
/// alone) become LF.
void normalise_line_breaks(std::string& text);

/// Walks over the lines of a text. Lines end with LF or CR LF; the last one may have no end.
class LineReader {
 public:
  explicit LineReader(std::string_view text) : rest_(text) {}
  bool next(Line& line);

 private:
  std::string_view rest_;
  std::size_t number_ = 0;
};

/// What a line's tokens hold beside ordinary characters.
struct TokenTraits {
  bool has_control = false;    ///< a control character (blanks are none)
  bool has_non_ascii = false;  ///< a byte above 127
  bool has_brace = false;      ///< '{'
};

/// The line's tokens, separated by blanks, up to a `#`. None for a line that starts with `//`.
TokenTraits tokenize(std::string_view line, std::vector<Token>& tokens);

}  // namespace lichtraum::esdf
