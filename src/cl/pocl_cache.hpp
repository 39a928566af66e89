#pragma once

#include <optional>
#include <string>

namespace lichtraum {

/// PoCL has no device where it cannot write the programs that it compiles: to $POCL_CACHE_DIR, else below
/// $XDG_CACHE_HOME, else below $HOME/.cache. Where that folder cannot be written (a container without a home, say),
/// this sets POCL_CACHE_DIR of this process to a folder in the temporary directory that only this user may write.
///
/// To be called before any OpenCL call. Returns what is in the way when there is no such folder either.
std::optional<std::string> ensure_pocl_cache();

}  // namespace lichtraum
