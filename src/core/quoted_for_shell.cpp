#include "core/quoted_for_shell.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>

namespace lichtraum {

std::string quoted_for_shell(std::string const& word) {
  constexpr std::string_view harmless = "-_./,:=+@%";
  bool const is_harmless = !word.empty() && std::all_of(word.begin(), word.end(), [&](unsigned char c) {
    return std::isalnum(c) || harmless.find(char(c)) != std::string_view::npos;
  });
  if (is_harmless) return word;
  std::string text = "'";
  for (char const c : word) text += c == '\'' ? "'\\''" : std::string(1, c);
  return text + "'";
}

}  // namespace lichtraum
