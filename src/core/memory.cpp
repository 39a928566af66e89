#include "core/memory.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>

namespace lichtraum {

std::uint64_t usable_memory_bytes() {
  auto bytes = std::uint64_t(::sysconf(_SC_PHYS_PAGES)) * std::uint64_t(::sysconf(_SC_PAGE_SIZE));
  // Version 2 of control groups, then version 1. Without a limit the first says "max".
  for (char const* const file : {"/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory/memory.limit_in_bytes"}) {
    std::uint64_t limit = 0;
    if (std::ifstream(file) >> limit) bytes = std::min(bytes, limit);
  }
  return bytes;
}

std::string bytes_text(double bytes) {
  for (char const* const unit : {"bytes", "kB", "MB", "GB", "TB", "PB"}) {
    if (bytes < 1000) return fmt::format("{:.3g} {}", bytes, unit);
    bytes /= 1000;
  }
  return fmt::format("{:.3g} EB", bytes);
}

}  // namespace lichtraum
