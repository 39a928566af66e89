#pragma once

#include <cstddef>
#include <filesystem>
#include <limits>
#include <system_error>

namespace lichtraum {

/// Calls `see` with each entry, at most `limit` of them. A folder that cannot be listed, or not to its end, as when a
/// share goes away, has no more: a loop over a directory_iterator would throw there, whatever its constructor is given.
template <class See>
void for_each_entry(std::filesystem::path const& folder, See const& see,
                    std::size_t limit = std::numeric_limits<std::size_t>::max()) {
  std::error_code error;
  std::filesystem::directory_iterator entry(folder, error);
  for (std::filesystem::directory_iterator const end; !error && entry != end && limit > 0; entry.increment(error)) {
    --limit;
    see(*entry);
  }
}

}  // namespace lichtraum
