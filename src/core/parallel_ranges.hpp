#pragma once

#include <algorithm>
#include <cstddef>
#include <thread>

#include "core/start_threads.hpp"

namespace lichtraum {

/// Calls work(begin, end) for ranges that make up 0..count, on every core; a range has `min_size` elements or more, so
/// that a thread is worth its start. `work` must not throw.
template <class Work>
void for_parallel_ranges(std::size_t count, std::size_t min_size, Work const& work) {
  std::size_t const most = std::max<std::size_t>(1, std::thread::hardware_concurrency());
  std::size_t const parts = std::clamp<std::size_t>(count / min_size, 1, most);
  auto const bound = [=](std::size_t part) { return count * part / parts; };
  auto const do_part = [&](std::size_t part) { work(bound(part), bound(part + 1)); };
  auto const threads = start_threads(parts - 1, do_part);
  for (std::size_t part = threads.size(); part < parts; ++part) do_part(part);
}

}  // namespace lichtraum
