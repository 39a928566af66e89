#pragma once

#include <cstddef>
#include <string_view>

#include "core/edit_distance.hpp"

namespace lichtraum {

/// Finds what somebody probably meant. Looks at a bounded number of names in its life, so that a file with many
/// mistakes and many names costs no more than a file with one.
class Suggester {
 public:
  /// Takes a name into account for the word being looked for.
  void consider(std::string_view name) {
    if (budget_ == 0) return;
    --budget_;
    std::size_t const distance = edit_distance(word_, name, limit_);
    if (distance < best_distance_) {
      best_distance_ = distance;
      best_ = name;
    }
  }
  template <class Names>
  void consider_all(Names const& names) {
    for (auto const& item : names) {
      if (budget_ == 0) return;
      if constexpr (requires { item->name(); }) {
        consider(item->name());
      } else if constexpr (requires { item.name(); }) {
        consider(item.name());
      } else {
        consider(item);
      }
    }
  }

  /// Starts a search for `word`, which must outlive it.
  void look_for(std::string_view word) {
    word_ = word;
    limit_ = likely_slips(word);
    best_distance_ = limit_ + 1;
    best_ = {};
  }
  /// The nearest name considered, or an empty text.
  std::string_view best() const { return best_; }

 private:
  std::size_t budget_ = 1'000'000;
  std::size_t limit_ = 0;
  std::size_t best_distance_ = 0;
  std::string_view word_;
  std::string_view best_;
};

}  // namespace lichtraum
