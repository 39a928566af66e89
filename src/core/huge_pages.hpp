#pragma once

#include <sys/mman.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace lichtraum {

/// The system may give this memory in large pages, as most of the time that filling tens of megabytes takes goes into
/// one page fault every four kilobytes. Only advice; without effect where there are none.
inline void advise_huge_pages(void* memory, std::size_t bytes) {
#ifdef MADV_HUGEPAGE
  constexpr std::uintptr_t page = std::uintptr_t(1) << 21;
  auto const begin = (reinterpret_cast<std::uintptr_t>(memory) + page - 1) / page * page;
  auto const end = (reinterpret_cast<std::uintptr_t>(memory) + bytes) / page * page;
  if (begin < end) ::madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
#endif
}

/// reserve() of a vector or string that becomes long.
template <class List>
void reserve_in_huge_pages(List& list, std::size_t size) {
  if (size <= list.capacity()) return;
  list.reserve(std::max(size, 2 * list.capacity()));  // twice: many small additions stay linear
  advise_huge_pages(list.data(), list.capacity() * sizeof(typename List::value_type));
}

}  // namespace lichtraum
