#include "io/text/lines.hpp"

namespace lichtraum {

void normalise_line_breaks(std::string& text) {
  if (text.compare(0, 3, "\xEF\xBB\xBF") == 0) text.erase(0, 3);
  for (std::size_t at = text.find('\r'); at != std::string::npos; at = text.find('\r', at + 1)) {
    if (at + 1 == text.size() || text[at + 1] != '\n') text[at] = '\n';
  }
}

bool LineReader::next(Line& line) {
  if (rest_.empty()) return false;
  std::size_t const end = rest_.find(line_break_);
  line.text = rest_.substr(0, end);
  rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
  if (!line.text.empty() && line.text.back() == '\r') line.text.remove_suffix(1);
  line.number = ++number_;
  return true;
}

}  // namespace lichtraum
