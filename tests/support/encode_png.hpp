#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>

namespace lichtraum::test {

/// A PNG of eight bits each of red, green, blue and alpha, first row at the top.
std::string encode_png(int width, int height, std::span<std::array<std::uint8_t, 4> const> pixels);

}  // namespace lichtraum::test
