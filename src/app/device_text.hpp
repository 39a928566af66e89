#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "lichtraum/words.hpp"

namespace lichtraum::app {

inline std::string_view kind_name(DeviceKind kind) {
  return find_word(std::span<Word<DeviceKind> const>(device_kind_words), kind);
}

constexpr double gibibytes(std::uint64_t bytes) { return double(bytes) / double(std::uint64_t(1) << 30); }

}  // namespace lichtraum::app
