#pragma once

#include <filesystem>
#include <system_error>

namespace lichtraum {

/// Calls `see` with each entry. A folder that cannot be listed, or not to its end, as when a share goes away, has no
/// more: a loop over a directory_iterator would throw there, whatever its constructor is given.
template <class See>
void for_each_entry(std::filesystem::path const& folder, See const& see) {
  std::error_code error;
  for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    see(*entry);
  }
}

}  // namespace lichtraum
