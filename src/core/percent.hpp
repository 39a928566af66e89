#pragma once

#include <string>
#include <string_view>

namespace lichtraum {

/// Of URIs: %20 becomes a blank; a '%' without two hex digits, and '+', stay as they are.
std::string decode_percent(std::string_view text);

}  // namespace lichtraum
