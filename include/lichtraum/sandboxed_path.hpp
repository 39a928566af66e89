#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "lichtraum/api.hpp"

namespace LICHTRAUM_API lichtraum {

/// A path that a scene file asks for: either where it leads, or why it must not be used.
struct SandboxedPath {
  std::filesystem::path path;  ///< absolute and without symbolic links; its last parts need not exist
  std::string reason;          ///< empty when the path may be used; reads on after "cannot use 'x': "
  bool is_outside = false;     ///< that it lies outside is why: one more allowed folder would do
  explicit operator bool() const { return reason.empty(); }
};

/// Where `requested`, as written in a scene file, leads from the folder `base`. Refused unless it is relative, has no
/// `..` and stays below `base` when every symbolic link is followed, or leads (then also absolute or with `..`) below
/// one of `allowed`. Nothing is opened or created.
SandboxedPath resolve_sandboxed(std::filesystem::path const& base, std::filesystem::path const& requested,
                                std::span<std::filesystem::path const> allowed = {});

}  // namespace lichtraum
