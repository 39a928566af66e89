#include "core/edit_distance.hpp"

#include <algorithm>
#include <array>

namespace lichtraum {

std::size_t edit_distance(std::string_view a, std::string_view b, std::size_t limit) {
  constexpr std::size_t longest = 64;
  std::size_t const too_far = limit + 1;
  if (a.size() > longest || b.size() > longest) return too_far;
  if (a.size() > b.size() + limit || b.size() > a.size() + limit) return too_far;

  using Row = std::array<std::size_t, longest + 1>;
  Row before_last{};
  Row last{};
  Row row{};
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    // Only cells within `limit` of the diagonal can matter; their neighbours outside count as too far.
    std::size_t const first = i > limit ? i - limit : 1;
    std::size_t const stop = std::min(b.size(), i + limit);
    row[first - 1] = first == 1 ? i : too_far;
    std::size_t best = row[first - 1];
    for (std::size_t j = first; j <= stop; ++j) {
      std::size_t const above = j < i + limit ? last[j] : too_far;
      std::size_t cost = std::min({above + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) cost = std::min(cost, before_last[j - 2] + 1);
      row[j] = cost;
      best = std::min(best, cost);
    }
    if (best > limit) return too_far;
    before_last = last;
    last = row;
  }
  return std::min(last[b.size()], too_far);
}

std::size_t likely_slips(std::string_view word) {
  return word.size() < 2 ? 0 : std::clamp<std::size_t>(word.size() / 3, 1, 3);
}

}  // namespace lichtraum
