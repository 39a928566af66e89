#pragma once

#include <string>
#include <string_view>

namespace lichtraum {

/// With A to Z as a to z, whatever the locale; other bytes stay.
inline std::string to_lower_ascii(std::string_view text) {
  std::string result(text);
  for (char& c : result) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c + ('a' - 'A'));
  }
  return result;
}

}  // namespace lichtraum
