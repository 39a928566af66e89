#pragma once

#include <sys/mman.h>

#include <algorithm>
#include <cstdint>

namespace lichtraum {

/// reserve() of a vector or string that becomes long: the system may give memory in large pages, as most of the time
/// that filling tens of megabytes takes goes into one page fault every four kilobytes. Only advice; without effect
/// where there are none.
template <class List>
void reserve_in_huge_pages(List& list, std::size_t size) {
  if (size <= list.capacity()) return;
  list.reserve(std::max(size, 2 * list.capacity()));  // twice: many small additions stay linear
#ifdef MADV_HUGEPAGE
  constexpr std::uintptr_t page = std::uintptr_t(1) << 21;
  auto const begin = (reinterpret_cast<std::uintptr_t>(list.data()) + page - 1) / page * page;
  auto const end = reinterpret_cast<std::uintptr_t>(list.data() + list.capacity()) / page * page;
  if (begin < end) ::madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
#endif
}

}  // namespace lichtraum
