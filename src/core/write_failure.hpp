#pragma once

#include <string>

namespace lichtraum {

/// Why nothing could be written, for an error number of the system's.
std::string write_failure(int code);

}  // namespace lichtraum
