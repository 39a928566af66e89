#include "app/terminal_graphics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace lichtraum::app {
namespace {

using Color = std::array<std::uint8_t, 3>;

std::uint8_t to_byte(float value) {
  return static_cast<std::uint8_t>(value > 0 ? std::min(value, 1.0f) * 255 + 0.5f : 0);  // NaN is black
}

Color color_at(Image const& image, int x, int y) {
  float const* const p = image.pixel(x, y);
  return {to_byte(p[0]), to_byte(p[1]), to_byte(p[2])};
}

std::string base64(std::string_view bytes) {
  constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::size_t const count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k) bits = bits << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k) text += k <= count ? digits[bits >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

/// The nearest of 6 steps a channel, and what it differs by handed on to the neighbours.
class CubeDither {
 public:
  explicit CubeDither(Image const& image) : image_(image), width_(image.width()) {
    errors_.resize(2 * 3 * std::size_t(width_ + 2));
  }

  /// The colours' numbers, red * 36 + green * 6 + blue, of the next row.
  std::vector<int> next_row(int y) {
    std::vector<int> row(static_cast<std::size_t>(width_));
    std::fill(below(), below() + 3 * (width_ + 2), 0.0f);
    for (int x = 0; x < width_; ++x) {
      int number = 0;
      for (int c = 0; c < 3; ++c) {
        float const value = image_.pixel(x, y)[c];
        float const wanted = (value > 0 ? std::min(value, 1.0f) : 0.0f) + here()[3 * (x + 1) + c];
        int const step = std::clamp(int(wanted * 5 + 0.5f), 0, 5);
        float const error = wanted - float(step) / 5;
        here()[3 * (x + 2) + c] += error * 7 / 16;
        below()[3 * x + c] += error * 3 / 16;
        below()[3 * (x + 1) + c] += error * 5 / 16;
        below()[3 * (x + 2) + c] += error * 1 / 16;
        number = 6 * number + step;
      }
      row[static_cast<std::size_t>(x)] = number;
    }
    is_swapped_ = !is_swapped_;
    return row;
  }

 private:
  float* half(bool second) { return errors_.data() + (second ? 3 * (width_ + 2) : 0); }
  float* here() { return half(is_swapped_); }
  float* below() { return half(!is_swapped_); }

  Image const& image_;
  int width_;
  std::vector<float> errors_;  // two rows with a pixel on either side
  bool is_swapped_ = false;
};

/// One colour's part of six rows: a character a column, repetitions counted.
std::string sixel_row(std::vector<std::uint8_t> const& bits) {
  std::string text;
  for (std::size_t x = 0; x < bits.size();) {
    std::size_t end = x;
    while (end < bits.size() && bits[end] == bits[x]) ++end;
    char const character = static_cast<char>('?' + bits[x]);
    if (end - x > 3) {
      text += fmt::format("!{}{}", end - x, character);
    } else {
      text.append(end - x, character);
    }
    x = end;
  }
  return text;
}

}  // namespace

std::string encode_blocks(Image const& image) {
  std::string text;
  for (int y = 0; y < image.height(); y += 2) {
    Color last_upper{}, last_lower{};
    for (int x = 0; x < image.width(); ++x) {
      Color const upper = color_at(image, x, y);
      if (x == 0 || upper != last_upper) text += fmt::format("\x1b[38;2;{};{};{}m", upper[0], upper[1], upper[2]);
      last_upper = upper;
      if (y + 1 < image.height()) {
        Color const lower = color_at(image, x, y + 1);
        if (x == 0 || lower != last_lower) text += fmt::format("\x1b[48;2;{};{};{}m", lower[0], lower[1], lower[2]);
        last_lower = lower;
      }
      text += "\xe2\x96\x80";
    }
    text += "\x1b[0m\n";
  }
  return text;
}

std::string encode_kitty(Image const& image) {
  constexpr std::size_t chunk_size = 4096;
  std::string pixels;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      for (std::uint8_t const value : color_at(image, x, y)) pixels.push_back(static_cast<char>(value));
    }
  }
  std::string const data = base64(pixels);
  std::string text;
  for (std::size_t at = 0; at < data.size(); at += chunk_size) {
    bool const is_last = at + chunk_size >= data.size();
    // q=2: the terminal does not answer, as nobody would read that.
    std::string const keys =
        at == 0 ? fmt::format("a=T,f=24,s={},v={},q=2,m={}", image.width(), image.height(), is_last ? 0 : 1)
                : fmt::format("m={}", is_last ? 0 : 1);
    text += fmt::format("\x1b_G{};{}\x1b\\", keys, data.substr(at, chunk_size));
  }
  return text + "\n";
}

std::string encode_sixel(Image const& image) {
  std::string text = fmt::format("\x1bP0;1q\"1;1;{};{}", image.width(), image.height());
  for (int number = 0; number < 216; ++number) {
    text += fmt::format("#{};2;{};{};{}", number, number / 36 * 20, number / 6 % 6 * 20, number % 6 * 20);
  }
  CubeDither dither(image);
  auto const width = static_cast<std::size_t>(image.width());
  for (int y = 0; y < image.height(); y += 6) {
    std::array<std::vector<std::uint8_t>, 216> bits;
    for (int row = 0; row < 6 && y + row < image.height(); ++row) {
      std::vector<int> const numbers = dither.next_row(y + row);
      for (std::size_t x = 0; x < width; ++x) {
        auto& columns = bits[static_cast<std::size_t>(numbers[x])];
        if (columns.empty()) columns.resize(width);
        columns[x] = static_cast<std::uint8_t>(columns[x] | 1 << row);
      }
    }
    for (std::size_t number = 0; number < bits.size(); ++number) {
      if (!bits[number].empty()) text += fmt::format("#{}{}$", number, sixel_row(bits[number]));
    }
    text += "-";
  }
  return text + "\x1b\\\n";
}

}  // namespace lichtraum::app
