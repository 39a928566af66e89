#pragma once

#include <cstddef>
#include <string_view>

namespace lichtraum {

/// How many characters (bytes) must be inserted, deleted, replaced or swapped with their neighbour to make `b` of `a`
/// (Damerau 1964, in the variant that edits no place twice), or `limit + 1` when that is more than `limit`. Texts
/// longer than 64 bytes count as more. Takes O(limit * length).
std::size_t edit_distance(std::string_view a, std::string_view b, std::size_t limit);

/// Up to how far from `word` somebody may have meant a known one: one slip in three letters, at most three. 'bleu' is
/// blue, 'box' is not 'row'.
std::size_t likely_slips(std::string_view word);

}  // namespace lichtraum
