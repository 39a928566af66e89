#pragma once

#include <string>

namespace lichtraum {

/// As one word of a command for a POSIX shell, in quotes where it needs them.
std::string quoted_for_shell(std::string const& word);

}  // namespace lichtraum
