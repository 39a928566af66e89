#include "compile/alias_table.hpp"

#include <algorithm>

namespace lichtraum {

// Vose, "A Linear Algorithm for Generating Random Numbers with a Given Distribution", IEEE Transactions on Software
// Engineering 17(9), 1991.
void AliasTableMaker::fill(std::span<double const> weights, std::span<device::AliasEntry> entries) {
  double sum = 0;
  for (double const weight : weights) sum += weight;
  std::size_t const count = weights.size();
  scaled_.resize(count);
  small_.clear();
  large_.clear();
  for (std::size_t i = 0; i < count; ++i) {
    scaled_[i] = sum > 0 ? weights[i] / sum * double(count) : 1;
    (scaled_[i] < 1 ? small_ : large_).push_back(device::uint(i));
  }
  auto const heaviest = device::uint(std::max_element(scaled_.begin(), scaled_.end()) - scaled_.begin());
  while (!small_.empty() && !large_.empty()) {
    device::uint const small = small_.back(), large = large_.back();
    small_.pop_back();
    entries[small] = {float(scaled_[small]), large};
    scaled_[large] = (scaled_[large] + scaled_[small]) - 1;
    if (scaled_[large] < 1) {
      large_.pop_back();
      small_.push_back(large);
    }
  }
  // What is left has 1 but for rounding.
  for (device::uint const i : large_) entries[i] = {1, i};
  for (device::uint const i : small_)
    entries[i] = sum > 0 && weights[i] == 0 ? device::AliasEntry{0, heaviest} : device::AliasEntry{1, i};
}

}  // namespace lichtraum
