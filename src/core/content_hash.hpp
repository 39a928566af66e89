#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace lichtraum {

/// What tells contents apart: 128 bits of XXH3. Equal contents have equal hashes on every machine of one byte order;
/// different ones meet by chance never, though someone could make two that do.
struct ContentHash {
  std::array<std::uint64_t, 2> words{};
  friend bool operator==(ContentHash const&, ContentHash const&) = default;

  /// 32 hexadecimal digits.
  std::string text() const;
};

/// Takes contents bit by bit.
class ContentHasher {
 public:
  ContentHasher();
  ~ContentHasher();
  ContentHasher(ContentHasher const&) = delete;
  ContentHasher& operator=(ContentHasher const&) = delete;

  void add_bytes(void const* bytes, std::size_t count);
  /// The bytes of `value`, which must have no padding.
  template <class T>
  requires std::is_trivially_copyable_v<T>
  void add(T const& value) { add_bytes(&value, sizeof value); }
  /// With its length: what follows cannot be taken for a part of it.
  template <class T, class Allocator>
  requires std::is_trivially_copyable_v<T>
  void add(std::vector<T, Allocator> const& values) {
    add(std::uint64_t(values.size()));
    add_bytes(values.data(), sizeof(T) * values.size());
  }
  void add(std::string_view text) {
    add(std::uint64_t(text.size()));
    add_bytes(text.data(), text.size());
  }

  ContentHash finish() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace lichtraum
