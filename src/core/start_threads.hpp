#pragma once

#include <cstddef>
#include <future>
#include <system_error>
#include <thread>
#include <vector>

namespace lichtraum {

/// Threads that call work(0), work(1), ... work(count - 1), or work(stop_token, 0), ...: as many of them, from the
/// first on, as the system gives. A limit (ulimit -u, a container's) makes things slower, it does not end them.
template <class Work>
std::vector<std::jthread> start_threads(std::size_t count, Work const& work) {
  std::vector<std::jthread> threads;
  threads.reserve(count);
  try {
    while (threads.size() < count) threads.emplace_back(work, threads.size());
  } catch (std::system_error const&) {
  }
  return threads;
}

/// For std::async: a thread, or, where the system gives none, the one that asks for the result. The function may be
/// moved from in between (GCC 12): let it only hold what can be copied, and pass it by name.
inline constexpr auto thread_if_any = std::launch::async | std::launch::deferred;

}  // namespace lichtraum
