#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

#include "io/ply/ply_header.hpp"
#include "io/text/numbers.hpp"

namespace lichtraum::ply {

/// Where numbers come from: both have the same functions, the data reader is a template over them.

/// Numbers as words, separated by blanks and line breaks.
class AsciiSource {
 public:
  AsciiSource(std::string_view text, std::size_t first_line, Diagnostics& diagnostics)
      : lines_(text), first_line_(first_line), bytes_left_(text.size()), diagnostics_(diagnostics) {}

  /// False at the end. What is not a number becomes a NaN, after a warning.
  bool number(Type, double& value) {
    Token word = next_token(rest_);
    while (word.empty()) {
      if (!lines_.next(line_)) {
        diagnostics_.begin_line({});
        return false;
      }
      line_.number += first_line_ - 1;
      rest_ = line_.text;
      bytes_left_ = lines_.rest().size() + rest_.size();
      diagnostics_.begin_line(line_);
      word = next_token(rest_);
    }
    if (!read_number_or_nan(word, value, diagnostics_)) value = std::numeric_limits<double>::quiet_NaN();
    word_ = word;
    return true;
  }
  bool skip(Type type, std::uint64_t count) {
    double ignored = 0;
    for (std::uint64_t i = 0; i < count; ++i) {
      if (!number(type, ignored)) return false;
    }
    return true;
  }
  /// How many numbers there can be at most.
  std::uint64_t capacity(Type) const { return bytes_left_ / 2 + 1; }
  void warn(std::string message) {
    diagnostics_.add(Severity::warning, DiagnosticCode::ply_data, word_, std::move(message));
  }

 private:
  LineReader lines_;
  std::size_t first_line_;
  std::size_t bytes_left_;
  Diagnostics& diagnostics_;
  Line line_;
  std::string_view rest_;
  Token word_;
};

/// Numbers as bytes, of either order.
class BinarySource {
 public:
  BinarySource(std::string_view bytes, std::size_t offset, bool is_big_endian, Diagnostics& diagnostics)
      : bytes_(bytes),
        at_(offset),
        is_swapped_(is_big_endian == (std::endian::native == std::endian::little)),
        diagnostics_(diagnostics) {
    diagnostics_.begin_line({});
  }

  bool number(Type type, double& value) {
    std::size_t const size = size_of(type);
    if (bytes_.size() - at_ < size) return false;
    char const* const from = bytes_.data() + at_;
    at_ += size;
    switch (type) {
      case Type::int8:
        value = load<std::int8_t>(from);
        break;
      case Type::uint8:
        value = load<std::uint8_t>(from);
        break;
      case Type::int16:
        value = load<std::int16_t>(from);
        break;
      case Type::uint16:
        value = load<std::uint16_t>(from);
        break;
      case Type::int32:
        value = load<std::int32_t>(from);
        break;
      case Type::uint32:
        value = load<std::uint32_t>(from);
        break;
      case Type::float32:
        value = double(std::bit_cast<float>(load<std::uint32_t>(from)));
        break;
      case Type::float64:
        value = std::bit_cast<double>(load<std::uint64_t>(from));
        break;
    }
    return true;
  }
  bool skip(Type type, std::uint64_t count) {
    if (count > capacity(type)) return false;
    at_ += std::size_t(count) * size_of(type);
    return true;
  }
  std::uint64_t capacity(Type type) const { return (bytes_.size() - at_) / size_of(type); }
  void warn(std::string const& message) {
    diagnostics_.add(Severity::warning, DiagnosticCode::ply_data, {}, "byte " + std::to_string(at_) + ": " + message);
  }

 private:
  template <class T>
  T load(char const* from) const {
    char bytes[sizeof(T)];
    for (std::size_t i = 0; i < sizeof(T); ++i) bytes[i] = from[is_swapped_ ? sizeof(T) - 1 - i : i];
    T value;
    std::memcpy(&value, bytes, sizeof value);
    return value;
  }

  std::string_view bytes_;
  std::size_t at_;
  bool is_swapped_;
  Diagnostics& diagnostics_;
};

}  // namespace lichtraum::ply
