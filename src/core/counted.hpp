#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <string_view>

namespace lichtraum {

/// "spheres", "boxes", "meshes".
inline std::string plural(std::string_view noun) {
  return fmt::format("{}{}", noun, noun.ends_with('x') || noun.ends_with('h') ? "es" : "s");
}

/// "1 box", "2 boxes".
inline std::string counted(std::uint64_t count, std::string_view noun) {
  return fmt::format("{} {}", count, count == 1 ? std::string(noun) : plural(noun));
}

}  // namespace lichtraum
