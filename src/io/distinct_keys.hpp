#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace lichtraum {

/// Numbers keys of `words` words from 0, equal ones alike, in the order in which they come: for corners that share a
/// vertex where all they say is the same. A hash table with open addressing, at most half full.
template <std::size_t words>
class DistinctKeys {
 public:
  using Key = std::array<std::uint32_t, words>;

  /// `most`: how many keys will come at most.
  explicit DistinctKeys(std::size_t most) : table_(std::bit_ceil(2 * most + 1), free_slot) {}

  /// The number of a key, and whether it is new.
  std::pair<std::uint32_t, bool> number_of(Key const& key) {
    std::size_t const mask = table_.size() - 1;
    std::size_t slot = hash_of(key) & mask;
    while (table_[slot] != free_slot && keys_[table_[slot]] != key) slot = (slot + 1) & mask;
    bool const is_new = table_[slot] == free_slot;
    if (is_new) {
      table_[slot] = std::uint32_t(keys_.size());
      keys_.push_back(key);
    }
    return {table_[slot], is_new};
  }

 private:
  static constexpr std::uint32_t free_slot = 0xFFFFFFFF;

  static std::size_t hash_of(Key const& key) {
    std::uint64_t hash = 0;
    for (std::uint32_t const word : key) hash = (hash ^ (hash >> 32)) * 0x9E3779B97F4A7C15u + word;
    hash = (hash ^ (hash >> 32)) * 0x94D049BB133111EBu;
    return std::size_t(hash ^ (hash >> 31));
  }

  std::vector<std::uint32_t> table_;  // numbers of keys
  std::vector<Key> keys_;
};

}  // namespace lichtraum
