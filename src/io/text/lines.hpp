#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace lichtraum {

using Token = std::string_view;  ///< always a part of its line, so that its column can be told

struct Line {
  std::string_view text;   ///< without its line break
  std::size_t number = 0;  ///< from 1
};

/// Removes what separates files and not statements: a byte order mark at the start; line breaks of old Macs (a CR
/// alone) become LF.
void normalise_line_breaks(std::string& text);

/// Walks over the lines of a text. Lines end with LF or CR LF, or as `line_break` says; the last one may have no end.
class LineReader {
 public:
  explicit LineReader(std::string_view text, char line_break = '\n') : rest_(text), line_break_(line_break) {}
  bool next(Line& line);
  /// What follows the line that was read last.
  std::string_view rest() const { return rest_; }

 private:
  std::string_view rest_;
  char line_break_;
  std::size_t number_ = 0;
};

/// Takes the next word, up to a blank, from the front of `rest`; an empty one just after the text when there is none.
inline Token next_token(std::string_view& rest) {
  auto const is_blank = [](char c) { return c == ' ' || (c >= '\t' && c <= '\r'); };
  std::size_t begin = 0;
  while (begin < rest.size() && is_blank(rest[begin])) ++begin;
  std::size_t end = begin;
  while (end < rest.size() && !is_blank(rest[end])) ++end;
  Token const token = rest.substr(begin, end - begin);
  rest.remove_prefix(end);
  return token;
}

/// `text` without blanks at its ends.
inline Token trimmed(std::string_view text) {
  constexpr char const* blanks = " \t\v\f\r";
  std::size_t const begin = text.find_first_not_of(blanks);
  if (begin == std::string_view::npos) return text.substr(text.size());
  return text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

}  // namespace lichtraum
