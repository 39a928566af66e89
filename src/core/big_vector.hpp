#pragma once

#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/huge_pages.hpp"

namespace lichtraum {

template <class T>
struct BigAllocator {
  static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);
  using value_type = T;

  BigAllocator() = default;
  template <class U>
  explicit(false) BigAllocator(BigAllocator<U> const&) {}
  friend bool operator==(BigAllocator const&, BigAllocator const&) { return true; }

  T* allocate(std::size_t count) {
    T* const memory = std::allocator<T>().allocate(count);
    advise_huge_pages(memory, count * sizeof(T));
    return memory;
  }
  void deallocate(T* memory, std::size_t count) { std::allocator<T>().deallocate(memory, count); }

  template <class U>
  void construct(U*) {}
  template <class U, class... Arguments>
  requires(sizeof...(Arguments) > 0) void construct(U* at, Arguments&&... arguments) {
    std::construct_at(at, std::forward<Arguments>(arguments)...);
  }
};

/// A vector for tens of megabytes that several threads fill: in large pages, and what resize() adds has no values, as
/// writing twice would cost as much as filling it does.
template <class T>
using BigVector = std::vector<T, BigAllocator<T>>;

}  // namespace lichtraum
